#!/usr/bin/env python3
"""Golden motions of the nonlinear model by mpmath, which shares no line with the flow: tests/second_opinion.py [ID ...]

The right-hand side is the paper's, as it is printed: (3) for craft 1, craft 2 by (4), the charge product by (7) and (18), the
distance by (13). Time alone is in radians of orbit, for in seconds mpmath's steps stall. Exit 1 where a coordinate differs by
more than 1e-30 of the largest of its kind.
"""
import csv
import sys

from mpmath import mp, mpf, odefun, sqrt

GOLDEN = 'data/golden/flow_nonlinear.csv'
MOTIONS = ['flow_nonlinear-paper-172800', 'flow_nonlinear-light-and-heavy-43200', 'flow_nonlinear-free-gains-43200']
INPUTS, STATE = 8, 6  # Omega k_c m1 m2 L_ref C1 C2 t, then the state at 0 and at t


def rates(Omega, k_c, m1, m2, L_ref, C1, C2):
    def per_radian(_, state):
        x1, y1, z1, x1_dot, y1_dot, z1_dot = state
        x2, y2, z2 = (-m1/m2*c for c in (x1, y1, z1))                                            # (4)
        L = (m1 + m2)/m2*sqrt(x1**2 + y1**2 + z1**2)                                             # (13)
        L_dot = (m1 + m2)/m2*(x1*x1_dot + y1*y1_dot + z1*z1_dot)/sqrt(x1**2 + y1**2 + z1**2)
        Q_ref = -3*Omega**2*L_ref**3/k_c*m1*m2/(m1 + m2)                                         # (7)
        dQ = m1*m2*L_ref**2/((m1 + m2)*k_c)*(-C1*(L - L_ref) - C2*L_dot)                         # (18)
        force = k_c/m1*(Q_ref + dQ)/L**3
        x1_ddot = 2*Omega*y1_dot + 3*Omega**2*x1 + force*(x1 - x2)                               # (3)
        y1_ddot = -2*Omega*x1_dot + force*(y1 - y2)
        z1_ddot = -Omega**2*z1 + force*(z1 - z2)
        return [rate/Omega for rate in (x1_dot, y1_dot, z1_dot, x1_ddot, y1_ddot, z1_ddot)]
    return per_radian


def worst(row):
    """The largest difference, of positions and of velocities, in units of the largest of them."""
    numbers = [mpf(float(cell)) for cell in row[1:1 + INPUTS + STATE]]  # an input is the nearest binary64
    expected = [mpf(cell) for cell in row[1 + INPUTS + STATE:1 + INPUTS + 2*STATE]]
    *parameters, t = numbers[:INPUTS]
    found = odefun(rates(*parameters), 0, numbers[INPUTS:])(parameters[0]*t)
    return max(abs(a - b)/max(map(abs, expected[half])) for half in (slice(0, 3), slice(3, 6))
               for a, b in zip(found[half], expected[half]))


def main():
    mp.dps = 40
    asked = sys.argv[1:] or MOTIONS
    with open(GOLDEN, newline='') as file:
        rows = {row[0]: row for row in csv.reader(file)}
    failed = 0
    for name in asked:
        error = worst(rows[name])
        fine = error <= mpf('1e-30')
        failed += not fine
        print(f"{'ok' if fine else 'not ok'} {name}: {mp.nstr(error, 2)}")
    print(f'{len(asked) - failed} passed, {failed} failed')
    return 1 if failed or not asked else 0


if __name__ == '__main__':
    sys.exit(main())
