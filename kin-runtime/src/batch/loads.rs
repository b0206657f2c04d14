//! Loads in many poses, of one mechanism or of many.

use super::Column;
use super::outcome::LengthMismatch;
#[cfg(feature = "rayon")]
use super::parallel::ParallelBatch;
use super::sweep::{Batch, Guide};
use crate::load::{Balance, LoadError, LoadsOf};
use crate::mechanism::Mechanism;
use crate::number::Row;

impl<'a, M: Mechanism<Scalar = f64>, G: Guide<'a, M>> Batch<'a, M, G> {
    /// The balances of all poses. `read` takes from each what is wanted, or handles its error: the results are stored
    /// in the order of the columns.
    ///
    /// Each result is that of [`Loaded::balance`](crate::load::Loaded::balance), to the last bit. Nothing is allocated.
    ///
    /// ```
    /// use kin_core::batch::Column;
    /// use kin_core::load::Loads;
    /// use kin_core::prelude::*;
    ///
    /// mechanism! {
    ///     /// Slider-crank in metres.
    ///     struct Engine { crank: Length, rod: Length }
    ///     input theta: Angle;
    ///     unknown phi: Angle, s: Length;
    ///     crank * cis(theta) + rod * cis(phi) == vec2(s, 0);
    ///     output piston: Point = vec2(s, 0);
    /// }
    ///
    /// let loads = Loads::<Engine>::new().mass(0.8, |pose| pose.piston);
    /// // rods of several lengths, in one position of the crank
    /// let rods = [0.12, 0.15, 0.18, 0.04];
    /// let engines = Engine { crank: Column::Same(0.05), rod: Column::Each(&rods) };
    /// let crank = Motion::at_constant_speed(1.0, rpm(3000.0)).map(Column::Same);
    /// let mut torques = [0.0; 4];
    /// engines.batch(crank, Assembly::Open).balance(
    ///     &loads,
    ///     |balance| balance.map_or(f64::NAN, |balance| balance.efforts()[0].value()),
    ///     &mut torques,
    /// )?;
    /// assert!(torques[0] < torques[2]);
    /// // the last rod does not reach
    /// assert!(torques[3].is_nan());
    /// # Ok::<(), kin_core::batch::LengthMismatch>(())
    /// ```
    ///
    /// # Errors
    /// [`LengthMismatch`] if the length of a column differs from the number of results. Nothing is solved then.
    pub fn balance<R>(
        &self,
        loads: &impl LoadsOf<M>,
        read: impl Fn(Result<Balance<M>, LoadError>) -> R,
        results: &mut [R],
    ) -> Result<(), LengthMismatch> {
        self.check_lengths(results.len())?;
        for (index, result) in results.iter_mut().enumerate() {
            *result = read(self.balance_of(loads, index));
        }
        Ok(())
    }

    fn balance_of(&self, loads: &impl LoadsOf<M>, index: usize) -> Result<Balance<M>, LoadError> {
        let near = self.guide.near();
        let mechanism = M::from_parameters(Row::from_fn(|parameter| self.parameters[parameter].at(index)));
        let inputs = M::Inputs::from_fn(|input| {
            let orders: M::Motion<Column<'_>> = self.inputs[input];
            M::Motion::from_fn(|order| orders[order].at(index))
        });
        let near = Row::from_fn(|unknown| near[unknown].at(index));
        self.guide.balance(&mechanism, loads, inputs, near)
    }
}

#[cfg(feature = "rayon")]
impl<'a, M: Mechanism<Scalar = f64>, G: Guide<'a, M>> ParallelBatch<'a, M, G>
where
    Batch<'a, M, G>: Sync,
{
    /// [`Batch::balance`] on all cores.
    ///
    /// # Errors
    /// As there.
    pub fn balance<R: Send>(
        &self,
        loads: &(impl LoadsOf<M> + Sync),
        read: impl Fn(Result<Balance<M>, LoadError>) -> R + Sync,
        results: &mut [R],
    ) -> Result<(), LengthMismatch> {
        use rayon::prelude::*;

        let batch = &self.0;
        batch.check_lengths(results.len())?;
        results
            .par_iter_mut()
            .enumerate()
            .for_each(|(index, result)| *result = read(batch.balance_of(loads, index)));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::{Balance, Batch, Column, LengthMismatch, LoadError};
    use crate::assembly::{Assembly, Near};
    use crate::geometry::Plane;
    use crate::library::{ClassThreeTriad, FiveBar};
    use crate::load::{Load, Loaded as _, Loads};
    use crate::mechanism::Mechanism;
    use crate::number::{Number, Row};

    crate::mechanism! {
        /// Four-bar linkage with the middle of its coupler.
        struct Press { r1: Length, r2: Length, r3: Length, r4: Length }
        input theta2: Angle;
        unknown theta3: Angle, theta4: Angle;
        r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
        output coupler: Point = r2 * cis(theta2) + r3 / 2 * cis(theta3);
    }

    /// Whatever a balance holds, and its error.
    fn all<M: Mechanism<Scalar = f64>>(balance: Result<Balance<M>, LoadError>) -> Result<Vec<f64>, LoadError> {
        let balance = balance?;
        let mut numbers = Vec::new();
        for effort in balance.efforts().as_ref() {
            numbers.extend(effort.as_slice());
        }
        for row in balance.inertias().as_ref() {
            for inertia in row.as_ref() {
                numbers.extend(inertia.as_slice());
            }
        }
        numbers.extend(balance.kinetic_energy().as_slice());
        numbers.extend(balance.potential_energy().as_slice());
        for vector in [balance.shaking_force(), balance.shaking_moment()] {
            numbers.extend(vector.as_slice().iter().flat_map(|entry| [entry.x, entry.y, entry.z]));
        }
        Ok(numbers)
    }

    /// Columns of all dimensions and all orders of all inputs, around a mechanism and values of its inputs.
    fn check<M>(
        mechanism: &M,
        loads: &Loads<M, impl Load<M> + Sync>,
        [middle, reach]: [M::Inputs<f64>; 2],
        assembly: M::Assembly,
        with_failures: bool,
    ) where
        M: Mechanism<Scalar = f64, Assembly: Sync>,
        for<'a> M::Parameters<Column<'a>>: Sync,
        for<'a> M::Inputs<M::Motion<Column<'a>>>: Sync,
    {
        const COUNT: usize = 101;
        let part = |row: u8| f64::from(row) / 50.0 - 1.0;
        let dimensions: Vec<Vec<f64>> = (1_u8..)
            .zip(mechanism.parameters().as_ref())
            .map(|(number, dimension)| {
                (0..101)
                    .map(|row| dimension * (1.0 + 1e-3 * f64::from(number) * part(row)))
                    .collect()
            })
            .collect();
        let motions: Vec<Vec<Vec<f64>>> = (0..<M::Inputs<f64> as Row<f64>>::LENGTH)
            .map(|input| {
                let entry = |order: u8, row: u8| match order {
                    0 => middle[input] + reach[input] * part(row),
                    _ => 3.0 * Number::sin_cos(f64::from(order) + f64::from(row)).0,
                };
                (0..5)
                    .map(|order| (0..101).map(|row| entry(order, row)).collect())
                    .collect()
            })
            .collect();
        let parameters: M::Parameters<Column<'_>> = Row::from_fn(|parameter| Column::Each(&dimensions[parameter]));
        let inputs: M::Inputs<M::Motion<Column<'_>>> =
            Row::from_fn(|input| Row::from_fn(|order| Column::Each(&motions[input][order])));
        let single: Vec<_> = (0..COUNT)
            .map(|row| {
                let member = M::from_parameters(Row::from_fn(|parameter| dimensions[parameter][row]));
                let inputs = Row::from_fn(|input| Row::from_fn(|order| motions[input][order][row]));
                all(member.balance(loads, inputs, assembly))
            })
            .collect();
        assert_eq!(single.iter().any(Result::is_err), with_failures);
        assert!(single.iter().any(Result::is_ok));
        let mut found = std::vec![Ok(Vec::new()); COUNT];
        let batch = Batch::<M, _>::new(parameters, inputs, assembly);
        batch.balance(loads, all, &mut found).expect("the columns fit");
        assert!(found == single);
        #[cfg(feature = "rayon")]
        {
            let mut found = std::vec![Ok(Vec::new()); COUNT];
            batch
                .on_all_cores()
                .balance(loads, all, &mut found)
                .expect("the columns fit");
            assert!(found == single);
        }
        let mut few = std::vec![Ok(Vec::new()); COUNT - 1];
        let mismatch = batch.balance(loads, all, &mut few);
        let quantity = M::DESCRIPTION.parameters[0].name;
        assert_eq!(
            mismatch,
            Err(LengthMismatch {
                quantity: quantity.into(),
                poses: COUNT - 1,
                length: COUNT
            })
        );
    }

    /// To the last bit, and with the same errors.
    #[test]
    fn a_batch_is_its_single_poses() {
        let press = Press {
            r1: 0.9,
            r2: 0.3,
            r3: 0.6,
            r4: 0.45,
        };
        let loads = Loads::<Press>::new()
            .gravity(Plane::new(0.0, -9.81))
            .mass(2.5, |pose| pose.coupler)
            .inertia(0.04, |pose| pose.theta4)
            .spring(800.0, 0.35, |pose| pose.coupler, |_| Plane::new(0.4, 0.9));
        check(&press, &loads, [[0.0], [3.0]], Assembly::Open, true);

        let robot = FiveBar {
            ground: 2.0,
            left: 1.5,
            left_rod: 2.4,
            right_rod: 2.4,
            right: 1.5,
        };
        let loads = Loads::<FiveBar>::new()
            .gravity(Plane::new(0.0, -9.81))
            .mass(3.0, |pose| pose.hand)
            .inertia(0.3, |pose| pose.beta);
        check(&robot, &loads, [[2.0, 1.1], [0.4, 0.4]], Assembly::Open, false);

        let triad = ClassThreeTriad {
            base_b: Plane::new(3.46, 0.1),
            base_c: Plane::new(1.7, 3.0),
            platform_b: Plane::new(1.7, 0.0),
            platform_c: Plane::new(0.9, 1.5),
        };
        let loads = Loads::<ClassThreeTriad>::new()
            .mass(6.0, |pose| pose.centre)
            .inertia(2.0, |pose| pose.phi);
        check(
            &triad,
            &loads,
            [[2.24; 3], [0.1; 3]],
            Near([0.1, 2.2, -2.0, 1.6]),
            false,
        );
    }
}
