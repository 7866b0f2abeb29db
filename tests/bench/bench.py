#!/usr/bin/env python3
"""Speed, as ratios measured in one run: bench.py PATH-OF-BENCH TABLE.md [ROUNDS]. Exit 1 when a ratio
falls short.

Every figure is a median over the rounds, of processor time. Both sides compute the same: mpmath from a
right-hand side that is written for it (radians of orbit, units of L_ref; in SI its steps stall).
"""
import math
import statistics
import subprocess
import sys
import time

import mpmath
from mpmath import iv, mp, mpf


def program(*arguments):
    """The numbers that one run of the C side prints."""
    line = subprocess.run([BENCH, *map(str, arguments)], check=True, stdout=subprocess.PIPE, text=True).stdout
    return [float(word) for word in line.split()] or sys.exit(f'bench.py: bench {arguments} measured nothing')


def timed(function, count=1):
    start = time.process_time()
    for _ in range(count):
        function()
    return (time.process_time() - start) / count


def closed_loop(_, state):
    """(3) closed by (7) and (18), n = 10."""
    x, y, z, u, v, w = state
    r = mpmath.sqrt(x*x + y*y + z*z)
    p = -(3 + 10*(r - 1) + 2*(x*u + y*v + z*w)/r)/r**3
    return [u, v, w, 2*v + (3 + p)*x, p*y - 2*u, (p - 1)*z]


def odefun():
    mp.dps = 50
    angle, r = mpf('0.01'), mpf('1.01')
    across = r*mpmath.cos(angle)
    start = [across*mpmath.cos(angle), across*mpmath.sin(angle), -r*mpmath.sin(angle)] + 3*[mpf(0)]
    return mpmath.odefun(closed_loop, 0, start)(mpf('7.2915e-5')*172800)


def interval():
    """eq07 from binary64, as the C side has it."""
    Omega, k_c, m1, m2, L = map(iv.mpf, (7.2915e-5, 8.99e9, 150.0, 150.0, 10.0))
    return -3*Omega**2*L**3/k_c*(m1*m2/(m1 + m2))


def polyroots():
    """(41) for n = 10, in units of Omega."""
    mp.dps = 40
    return mpmath.polyroots([1, 2, 8, 6, 3])


def exponent(points):
    """The slope of the line of least squares through the logarithms."""
    x, y = zip(*[(math.log(a), math.log(b)) for a, b in points])
    x0, y0 = statistics.mean(x), statistics.mean(y)
    return sum((a - x0)*(b - y0) for a, b in zip(x, y))/sum((a - x0)**2 for a in x)


def measure(rounds):
    """Medians, in seconds, and the largest radii. What is short is taken three times a round."""
    times = {}
    worst = {}
    iv.dps = 40
    for i in range(rounds):
        print(f'round {i + 1} of {rounds}', file=sys.stderr)
        times.setdefault('odefun', []).append(timed(odefun))
        for _ in range(3):
            times.setdefault('interval', []).append(timed(interval, 2000))
            times.setdefault('polyroots', []).append(timed(polyroots, 50))
            for name, *arguments in (('flow', 50, 2), ('unproved', 50, 2), ('flow5', 50, 5),
                                     ('square', 192, 0.5), ('picard', 192, 0.5), ('scalar', 40, 100000), ('roots', 40, 2000)):
                numbers = program(name.rstrip('5'), *arguments)
                times.setdefault(name, []).append(numbers[0])
                if len(numbers) > 1:
                    worst[name] = max(numbers[1], worst.get(name, numbers[1]))
    return {name: statistics.median(samples) for name, samples in times.items()}, worst


def show(rows):
    fine = True
    for what, figure, required, passed in rows:
        fine = fine and passed
        print(f'{what:<66} {figure:>9} {required:>10}  {"pass" if passed else "FAIL"}')
    return fine


def costs(title, points, unit):
    power = f'{unit}^{exponent(points):.2f}'
    print(f'\n{title}: seconds ~ {power}')
    print('  '.join(f'{size}: {seconds:.3g}' for size, seconds in points))
    return f'{power} ({points[0][0]} to {points[-1][0]})'


def write_markdown(path, rows, powers):
    with open(path, 'w', encoding='utf-8') as out:
        print('| what | measured | required |\n|---|---|---|', file=out)
        for what, figure, required, _ in rows:
            print(f'| {what} | {figure} | {required} |', file=out)
        print(f'\nThe time grows as {" and as ".join(powers)}.', file=out)


def main():
    rounds = int(sys.argv[3]) if len(sys.argv) > 3 else 5
    t, radius = measure(rounds)
    print(f'mpmath {mpmath.__version__} ({mpmath.libmp.BACKEND}), medians of {rounds} rounds\n')
    print(f'{"":<66} {"measured":>9} {"required":>10}')
    rows = []
    for what, other, own, least in (
            ('nonlinear trajectory, 50 digits, 2 days, against mpmath.odefun', 'odefun', 'flow', 80),
            ('eq07, 40 digits, against mpmath.iv', 'interval', 'scalar', 50),
            ('roots of (41), 40 digits, against mpmath.polyroots', 'polyroots', 'roots', 20)):
        ratio = t[other]/t[own]
        rows.append((what, f'{ratio:.1f}', f'>= {least}', ratio >= least))
    ratio = t['square']/t['picard']
    rows.append(('inverse-square field, certified, against Picard iteration without proofs', f'{ratio:.2f}', '<= 3', ratio <= 3))
    single = program('flow', 16, 3)[0]
    for what, cm, percent, most in (('+-1 cm', 1, 0, 1.2), ('+-2.5 cm', 2.5, 0, 1.6), ('+-5 mm and C1 +-1 %', 0.5, 1, 1.6),
                                    ('+-5 cm', 5, 0, math.inf)):
        taken, factor = program('set', cm, percent, 1000)
        rows.append((f'bounds of a set, {what}, over what 1,000 motions fill, 3 days', f'{factor:.2f}', f'<= {most}' if most < math.inf else '', factor <= most))
        if cm == 1:
            rows.append(('its processor time in single motions of 16 digits', f'{taken/single:.0f}', '<= 100', taken <= 100*single))
        if cm == 5:
            rows.append(('its processor time, seconds', f'{taken:.0f}', '<= 120', taken <= 120))
    ratio = t['flow']/t['unproved']
    rows.append(('the nonlinear trajectory, against the integrator without its proofs', f'{ratio:.2f}', '<= 2.5',
                 ratio <= 2.5))
    for name, days, most in (('flow', 2, -50), ('flow5', 5, -49)):
        rows.append((f'radius of the nonlinear trajectory over L_ref after {days} days', f'1e{math.ceil(radius[name])}', f'<= 1e{most}',
                     radius[name] <= most))
    fine = show(rows)
    print('\nmilliseconds: ' + ', '.join(f'{name} {1e3*seconds:.3g}' for name, seconds in t.items()))
    powers = [
        costs('digits, over 6 hours', [(d, program('flow', d, 0.25)[0]) for d in (16, 50, 100, 200, 500, 1000)], 'digits'),
        costs('days, 50 digits', [(d, program('flow', 50, d)[0]) for d in (2, 4, 8, 16, 30)], 'days')]
    write_markdown(sys.argv[2], rows, powers)
    return 0 if fine else 1


if __name__ == '__main__':
    if len(sys.argv) < 3:
        sys.exit('bench.py: expected the path of the program bench and that of the table to write')
    BENCH = sys.argv[1]
    sys.exit(main())
