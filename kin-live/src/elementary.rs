//! The elementary functions of one argument, as methods of a number.

macro_rules! functions {
    ($($variant:ident $method:ident)+) => {
        /// A method of a number without a further argument.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(crate) enum Elementary {
            $($variant,)+
        }

        impl Elementary {
            /// The function of a name.
            pub(crate) fn named(name: &str) -> Option<Self> {
                match name {
                    $(stringify!($method) => Some(Self::$variant),)+
                    _ => None,
                }
            }

            /// The same function of a declaration; none for that of two arguments.
            pub(crate) const fn declared(function: kin_compiler::Function) -> Option<Self> {
                match function {
                    $(kin_compiler::Function::$variant => Some(Self::$variant),)+
                    kin_compiler::Function::Atan2 => None,
                }
            }

            #[inline(always)]
            pub(crate) fn of<T: kin_core::Number>(self, a: T) -> T {
                match self {
                    $(Self::$variant => a.$method(),)+
                }
            }
        }
    };
}

functions! {
    Sin sin
    Cos cos
    Tan tan
    Asin asin
    Acos acos
    Atan atan
    Sinh sinh
    Cosh cosh
    Tanh tanh
    Asinh asinh
    Acosh acosh
    Atanh atanh
    Sqrt sqrt
    Exp exp
    Ln ln
}
