"""What mypy refuses, a mistake in each line that is marked."""

import kin

linkage = kin.library.four_bar(r1="90", r2=30, r3=70, r4=60)  # mistake
linkage.solve(theta2=1.0, assembly=0)  # mistake
linkage.sweep(theta2=(0.0, 6.0), rows="100")  # mistake
kin.Mechanism(3)  # mistake
value: str = linkage.cycle().stroke("theta4").length  # mistake
