//! The mechanisms of the library, each with dimensions, inputs and an assembly for which it closes.

/// A mechanism of the library, with dimensions and a position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Design {
    /// The name of the mechanism.
    pub name: &'static str,
    /// The file of kin-core that declares it.
    file: &'static str,
    /// The scalar parameters.
    pub parameters: &'static [f64],
    /// The inputs.
    pub inputs: &'static [f64],
    /// The assembly.
    pub assembly: DesignAssembly,
}

/// The assembly of a design.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DesignAssembly {
    /// The assembly of this name. The name is empty if the mechanism has one assembly.
    Named(&'static str),
    /// The assembly to which these values of the unknowns belong.
    Near(&'static [f64]),
}

impl Design {
    /// The text between the braces of its declaration, as [`kin_live::Mechanism::declare`] takes it.
    #[must_use]
    pub fn declaration(&self) -> &'static str {
        let head = format!("pub struct {} {{", self.name);
        let mut declarations = self.file.split("\ncrate::mechanism! {").skip(1);
        let found = declarations.find(|text| text.contains(&head)).unwrap_or_default();
        found.split("\n}\n").next().unwrap_or_default()
    }
}

/// An angle of so many degrees.
pub(super) const fn deg(angle: f64) -> f64 {
    angle.to_radians()
}

/// Calls a macro with all mechanisms in the order of the book's table: name and file, dimensions, inputs, and the
/// assembly.
macro_rules! each_design {
    ($call:ident) => {
        $call! {
            FourBar "four_bar" [90.0, 30.0, 80.0, 60.0] at [deg(70.0)] in "open";
            GeometricFourBar "geometric_four_bar"
                [90.0, 30.0, 80.0, 60.0] at [deg(70.0)] in "alpha=open,gamma=open,beta=open";
            FreudensteinFourBar "freudenstein_four_bar"
                [90.0, 30.0, 80.0, 60.0] at [deg(70.0)] in "theta4=crossed,theta3=crossed";
            SliderCrank "slider_crank" [1.0, 3.0] at [deg(60.0)] in "open";
            OffsetSliderCrank "slider_crank" [1.0, 3.0, -0.6] at [deg(60.0)] in "open";
            InvertedSliderCrank "inverted_slider_crank" [2.0, 1.0] at [deg(60.0)] in "";
            SliderCrankFirstApproximation "approximate_slider_crank" [1.0, 3.0] at [deg(60.0)] in "";
            SliderCrankHigherApproximation "approximate_slider_crank" [1.0, 3.0] at [deg(60.0)] in "";
            WhitworthQuickReturn "whitworth_quick_return" [0.05, 0.12, 0.1, 0.28] at [deg(40.0)] in "open";
            ScotchYoke "scotch_yoke" [1.0, deg(90.0)] at [deg(50.0)] in "";
            ChebyshevLinkage "chebyshev_linkage" [4.0, 5.0, 2.0] at [deg(60.0)] in "crossed";
            HoekenLinkage "hoeken_linkage" [2.0, 1.0, 2.5] at [deg(70.0)] in "open";
            RobertsLinkage "roberts_linkage" [2.0, 2.4] at [deg(60.0)] in "open";
            PeaucellierLinkage "peaucellier_linkage"
                [1.0, 1.0, 3.5, 1.8] at [deg(25.0)] in
                "alpha_gamma=open,beta_delta=crossed,epsilon_zeta=open";
            Pantograph "pantograph" [3.0, 3.0, 2.0] at [3.0, -1.5] in "alpha_gamma=open,beta_delta=open";
            FiveBar "five_bar" [2.0, 2.0, 3.0, 3.0, 2.0] at [deg(120.0), deg(50.0)] in "open";
            GearedFiveBar "five_bar" [4.0, 1.2, 3.4, 3.4, 1.2, -1.0, deg(180.0)] at [deg(110.0)] in "open";
            WattI "watt_six_bars"
                [4.0, 1.4, 3.0, 2.5, 1.0, 1.2, 2.0, 1.5, 2.5, 2.0] at [deg(50.0)] in
                "theta3_theta4=open,theta5_theta6=open";
            WattII "watt_six_bars"
                [4.0, 1.2, 3.0, 2.5, 2.0, -1.2, 8.0, 0.0, 3.2, 2.2] at [deg(60.0)] in
                "theta3_theta4=open,theta5_theta6=open";
            StephensonI "stephenson_six_bars"
                [4.0, 1.4, 3.6, 2.6, 1.4, 1.5, 2.2, -1.6, 4.0, 2.8] at [deg(70.0)] in
                "theta3_theta4=open,theta5_theta6=open";
            StephensonIIByElbow "stephenson_six_bars"
                [4.0, 1.2, 1.8, 2.2, 1.0, 0.8, 1.4, -1.0, 2.6, 2.4] at [-0.994_314_470_234_482_8] in
                "alpha_beta=crossed,theta2_theta6=open";
            StephensonIII "stephenson_six_bars"
                [4.0, 1.2, 3.4, 2.6, 2.2, 1.5, 3.8, 7.0, 0.5, 2.4] at [deg(70.0)] in
                "theta3_theta4=open,theta5_theta6=open";
            KlannLeg "klann_leg"
                [0.268, 0.59, 0.5221, 0.224_100_275_956_071_9, -0.59, -0.176, 0.3206, -0.233, 0.616,
                0.5177, 0.8966, 0.8966, deg(150.0)] at [deg(190.0)] in
                "phi_lower=crossed,psi_upper=open";
            JansenLeg "jansen_leg"
                [38.0, 41.5, 39.3, 40.1, 55.8, 39.4, 36.7, 65.7, 49.0, 50.0, 61.9, 7.8, 15.0] at
                [deg(60.0)] in
                "angle_j_angle_b=crossed,angle_k_angle_c=open,angle_f_angle_g=crossed";
            AndrewsSqueezer "andrews_squeezer"
                [0.007, 0.028, 0.035, 0.02, 0.04, 0.02, 0.04, -0.06934, -0.00227, -0.03635, 0.03273]
                at [0.7] in "beta_gamma=open,phi_delta=crossed,omega_epsilon=open";
            WattIByDyad "watt_six_bars"
                [4.0, 1.4, 3.0, 2.5, 1.0, 1.2, 2.0, 1.5, 2.5, 2.0] at [1.420_326_453_603_895_8] near
                [deg(50.0), 0.4811, 1.748, 2.7939];
            WattIIByCouplers "watt_six_bars"
                [4.0, 1.2, 3.0, 2.5, 2.0, -1.2, 8.0, 0.0, 3.2, 2.2] at [-0.536_909_594_690_403_6]
                near [deg(50.0), deg(30.0), 1.8258, 1.6361];
            StephensonIByDyad "stephenson_six_bars"
                [4.0, 1.4, 3.6, 2.6, 1.4, 1.5, 2.2, -1.6, 4.0, 2.8] at [0.416_669_841_320_838_8]
                near [deg(50.0), 0.4367, 1.5084, 2.5508];
            StephensonII "stephenson_six_bars"
                [4.0, 1.2, 1.8, 2.2, 1.0, 0.8, 1.4, -1.0, 2.6, 2.4] at [deg(50.0)] near [0.2, 0.6,
                0.3, 1.6];
            StephensonIIIByDyad "stephenson_six_bars"
                [4.0, 1.2, 3.4, 2.6, 2.2, 1.5, 3.8, 7.0, 0.5, 2.4] at [2.160_263_931_525_399] near
                [deg(50.0), 0.5125, 1.6731, -0.2149];
            ClassThreeTriad "class_three_triad"
                [6.928_203_230_275_509, 0.0, 3.464_101_615_137_754_4, 6.0, 1.732_050_807_568_877_2,
                0.0, 0.866_025_403_784_438_6, 1.5] at [3.4, 3.4, 3.6] near [0.5, 2.6, -1.5, 0.2];
            Rssr "rssr" [1.0, 0.0, 3.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 2.5, 3.0] at [deg(50.0)] in "open";
            Rssp "rssp" [1.0, 0.0, 3.0, 1.0, 0.0, 1.0, 0.0, 3.5] at [deg(50.0)] in "open";
            UniversalJoint "universal_joint" [deg(35.0)] at [deg(30.0)] in "open";
            SphericalFourBar "spherical_four_bar"
                [deg(70.0), deg(30.0), deg(60.0), deg(55.0)] at [deg(60.0)] in "open";
            StewartGoughLeg "stewart_gough_leg"
                [2.0, 0.0, 0.0, 1.0, 0.5, 0.0] at [0.3, 0.2, 3.0, 0.2, 0.1, 0.3] in "";
            Bennett "bennett" [2.0, deg(30.0), deg(70.0)] at [1.2] in "";
        }
    };
}

macro_rules! assembly {
    (in $name:literal) => {
        DesignAssembly::Named($name)
    };
    (near [$($value:expr),+]) => {
        DesignAssembly::Near(&[$($value),+])
    };
}

macro_rules! designs {
    ($($name:ident $file:literal [$($parameter:expr),+] at [$($input:expr),+] $kind:ident $assembly:tt;)+) => {
        &[$(Design {
            name: stringify!($name),
            file: include_str!(concat!("../../../kin-core/src/library/", $file, ".rs")),
            parameters: &[$($parameter),+],
            inputs: &[$($input),+],
            assembly: assembly!($kind $assembly),
        }),+]
    };
}

/// All designs, in the order of the book's table.
pub const DESIGNS: &[Design] = each_design!(designs);

#[cfg(feature = "gallery")]
pub(super) use each_design;
