#!/usr/bin/env python3
"""The equations of a Coulomb tether formation in Python, as a client of the oracle:

    coulomb-tether conform -- tests/clients/client.py

A function bears the number of its equation, its parameters the paper's symbols, in SI units.
Outside its domain it raises ValueError.
"""
import sys
from cmath import rect
from inspect import signature
from itertools import zip_longest
from math import atan2, copysign, cos, dist, exp, fmod, hypot, isfinite, prod, sin, sqrt

POSITIVE = {"Omega", "k_c", "lambda_d", "m1", "m2", "L", "L_ref", "GM", "R_c", "h"}


def require(condition):
    if not condition:
        raise ValueError("outside the domain")


# ---- the static formation ----

def eq02(Omega, k_c, lambda_d, *numbers):
    """Any number of craft on the Clohessy-Wiltshire-Hill equations, their charges shielded by the plasma."""
    craft = [numbers[i:i + 8] for i in range(0, len(numbers), 8)]
    accelerations = []
    for i, (m, q, x, y, z, x_dot, y_dot, z_dot) in enumerate(craft):
        require(m > 0)
        a = [2*Omega*y_dot + 3*Omega**2*x, -2*Omega*x_dot, -Omega**2*z]
        for m_j, q_j, *r_j in craft[:i] + craft[i + 1:]:
            d = dist((x, y, z), r_j[:3])
            require(d > 0)
            force = k_c*q*q_j/m*exp(-d/lambda_d)/d**3
            a = [a_k + force*(r - r_k) for a_k, r, r_k in zip(a, (x, y, z), r_j)]
        accelerations += a
    return accelerations


def eq03(Omega, k_c, m1, m2, Q, x1, y1, z1, x1_dot, y1_dot, z1_dot):
    """Craft 1 of a pair, craft 2 being where eq. (4) has it."""
    force = k_c*Q*(1/m1 + 1/m2)/eq13(m1, m2, x1, y1, z1)**3
    return (2*Omega*y1_dot + 3*Omega**2*x1 + force*x1,
            -2*Omega*x1_dot + force*y1,
            -Omega**2*z1 + force*z1)


def eq04(m1, m2, x1, y1, z1):
    return -m1/m2*x1, -m1/m2*y1, -m1/m2*z1


def eq05(m1, m2, L):
    return m2/(m1 + m2)*L, -m1/(m1 + m2)*L


def eq07(Omega, k_c, m1, m2, L):
    return -3*Omega**2*L**3/k_c*m1*m2/(m1 + m2)


# ---- the perturbed formation ----

def eq09(psi, theta):
    return (cos(theta)*cos(psi), cos(theta)*sin(psi), -sin(theta),
            -sin(psi), cos(psi), 0.0,
            sin(theta)*cos(psi), sin(theta)*sin(psi), cos(theta))


def eq10(m1, m2, L, psi, theta):
    """The first row of eq. (9), as long as craft 1 is far from the origin."""
    return tuple(m2/(m1 + m2)*L*b1 for b1 in eq09(psi, theta)[:3])


def eq10lin(m1, m2, L, psi, theta):
    rho1 = m2/(m1 + m2)*L
    return rho1, psi*rho1, -theta*rho1


def eq10inv(m1, m2, x1, y1, z1):
    # 0.0 added turns -0.0 into 0.0: psi is pi, not -pi, behind the origin, and 0 on the orbit normal.
    return eq13(m1, m2, x1, y1, z1), atan2(y1 + 0.0, x1 + 0.0), atan2(-z1, hypot(x1, y1))


def eq11exact(m1, m2, L, psi, theta, L_dot, psi_dot, theta_dot):
    across = L_dot*cos(theta) - L*theta_dot*sin(theta)
    along = L*psi_dot*cos(theta)
    return (m2/(m1 + m2)*(across*cos(psi) - along*sin(psi)),
            m2/(m1 + m2)*(across*sin(psi) + along*cos(psi)),
            m2/(m1 + m2)*(-L_dot*sin(theta) - L*theta_dot*cos(theta)))


def eq11(m1, m2, L, psi, theta, L_dot, psi_dot, theta_dot):
    return (m2/(m1 + m2)*L_dot,
            m2/(m1 + m2)*(psi*L_dot + psi_dot*L),
            m2/(m1 + m2)*(-theta*L_dot - theta_dot*L))


def eq12(x1, y1, z1, x2, y2, z2):
    L = dist((x1, y1, z1), (x2, y2, z2))
    require(L > 0)
    return L


def eq13(m1, m2, x1, y1, z1):
    L = (m1 + m2)/m2*hypot(x1, y1, z1)
    require(L > 0)
    return L


def eq14(Omega, k_c, m1, m2, Q, x1, y1, z1, x1_dot, y1_dot, z1_dot):
    """Solved for L_ddot: what L_dot^2 takes from v^2 leaves the speed across, |r x v|/r, without cancellation."""
    x1_ddot, y1_ddot, z1_ddot = eq03(Omega, k_c, m1, m2, Q, x1, y1, z1, x1_dot, y1_dot, z1_dot)
    r = hypot(x1, y1, z1)
    v_across = hypot(y1*z1_dot - z1*y1_dot, z1*x1_dot - x1*z1_dot, x1*y1_dot - y1*x1_dot)/r
    return (m1 + m2)/m2*(v_across**2 + x1*x1_ddot + y1*y1_ddot + z1*z1_ddot)/r


def eq15(Omega, k_c, m1, m2, L, psi_dot, Q):
    return (2*Omega*psi_dot + 3*Omega**2)*L + k_c/m1*Q/L**2*(m1 + m2)/m2


def eq17(Omega, k_c, m1, m2, L_ref, psi_dot, dL, dQ):
    return 2*Omega*L_ref*psi_dot + 9*Omega**2*dL + k_c/m1/L_ref**2*(m1 + m2)/m2*dQ


# ---- the control law ----

def eq18(k_c, m1, m2, L_ref, C1, C2, dL, dL_dot):
    return m1*m2*L_ref**2/((m1 + m2)*k_c)*(-C1*dL - C2*dL_dot)


def eq19(Omega, L_ref, C1, C2, dL, dL_dot, psi_dot):
    return -(C1 - 9*Omega**2)*dL - C2*dL_dot + 2*Omega*L_ref*psi_dot


def eq21(Q_ref, dQ):
    """The printed |Q_ref + dQ| would answer a command to repel with attraction: only attraction has charges."""
    Q = Q_ref + dQ
    require(Q < 0)
    return sqrt(-Q), -sqrt(-Q)


# ---- attitude ----

def eq25(Omega, theta):
    return -Omega*sin(theta), 0.0, Omega*cos(theta)


def eq26(theta, psi_dot, theta_dot):
    return -sin(theta)*psi_dot, theta_dot, cos(theta)*psi_dot


def eq27(Omega, theta, psi_dot, theta_dot):
    return -sin(theta)*(psi_dot + Omega), theta_dot, cos(theta)*(psi_dot + Omega)


def eq28(Omega, theta, psi_dot, theta_dot):
    return -Omega*theta, theta_dot, psi_dot + Omega


def eq29(Omega, theta_dot, theta_ddot, psi_ddot):
    return -Omega*theta_dot, theta_ddot, psi_ddot


def eq30(m1, m2, x1, y1, z1, x2, y2, z2):
    """Each craft with its own mass; the print has m1 twice."""
    return (m1*(y1**2 + z1**2) + m2*(y2**2 + z2**2), -m1*x1*y1 - m2*x2*y2, -m1*x1*z1 - m2*x2*z2,
            m1*(x1**2 + z1**2) + m2*(x2**2 + z2**2), -m1*y1*z1 - m2*y2*z2,
            m1*(x1**2 + y1**2) + m2*(x2**2 + y2**2))


def eq32(m1, m2, L):
    return m1*m2/(m1 + m2)*L**2


def eq34(m1, m2, L, L_dot):
    return 2*m1*m2/(m1 + m2)*L*L_dot


def eq36(R_c, psi, theta):
    return R_c*cos(theta)*cos(psi), -R_c*sin(psi), R_c*sin(theta)*cos(psi)


def eq37(GM, R_c1, R_c2, R_c3, I):
    """With the inertia of eq. (31): none about the line of the craft, I across it."""
    R_c = hypot(R_c1, R_c2, R_c3)
    require(R_c > 0 and I >= 0)
    return 0.0, -3*GM/R_c**5*R_c1*R_c3*I, 3*GM/R_c**5*R_c1*R_c2*I


def eq38(GM, R_c):
    """Kepler's third law; the print has a factor of 3 that belongs to eq. (39)."""
    return sqrt(GM/R_c**3)


def eq39(Omega, I, psi, theta):
    require(I >= 0)
    return 0.0, -3*Omega**2*I*theta, -3*Omega**2*I*psi


# ---- the linear model and its stability ----

def eq40(Omega, L_ref, C1, C2, psi, theta, dL, dL_dot, psi_dot):
    return (-4*Omega**2*theta,
            -2*Omega/L_ref*dL_dot - 3*Omega**2*psi,
            eq19(Omega, L_ref, C1, C2, dL, dL_dot, psi_dot))


def eq41(Omega, C1, C2):
    return 3*Omega**2*(C1 - 9*Omega**2), 3*C2*Omega**2, C1 - 2*Omega**2, C2, 1.0


def eq41roots(Omega, C1, C2):
    """In units of Omega, where the coefficients are near one: Durand and Kerner find all roots, Newton polishes each."""
    a = eq41(1.0, C1/Omega/Omega, C2/Omega)

    def p(z):
        return (((z + a[3])*z + a[2])*z + a[1])*z + a[0]

    def p_slope(z):
        return ((4*z + 3*a[3])*z + 2*a[2])*z + a[1]

    roots = [rect(1 + max(map(abs, a)), 0.4 + 1.6*k) for k in range(4)]
    for _ in range(300):  # a double root takes the most, as each step halves the distance
        before = roots[:]
        for i, z in enumerate(roots):
            spread = prod(z - other for other in roots[:i] + roots[i + 1:])
            roots[i] -= p(z)/spread if spread else 0
        if all(abs(z - old) <= 1e-15*abs(z) for z, old in zip(roots, before)):
            break

    for i, z in enumerate(roots):
        while p_slope(z) and abs(p(z - p(z)/p_slope(z))) < abs(p(z))/2:
            z -= p(z)/p_slope(z)
        roots[i] = Omega*z
    return [part for z in sorted(roots, key=lambda z: (z.real, z.imag)) for part in (z.real, z.imag)]


def eq42(Omega, C1, C2):
    margin1, margin2 = C1 - 9*Omega**2, C2
    return margin1, margin2, float(margin1 > 0 and margin2 > 0)


def eq43(Omega, n):
    require(n > 0)
    return n*Omega**2


def eq44(Omega, n):
    require(n >= 9)
    return 2*Omega*sqrt(n - 9)


# ---- motions, in units of time in which Omega = 1 ----

def linear_model(Omega, L_ref, C1, C2):
    """The slope of (psi, theta, dL and their rates) by eqs. (40)."""
    def slope(state):
        psi, theta, dL, psi_dot, theta_dot, dL_dot = state
        theta_ddot, psi_ddot, dL_ddot = eq40(1.0, L_ref, C1/Omega/Omega, C2/Omega, psi, theta, dL, dL_dot, psi_dot)
        return psi_dot, theta_dot, dL_dot, psi_ddot, theta_ddot, dL_ddot
    return slope


def nonlinear_model(Omega, k_c, m1, m2, L_ref, C1, C2):
    """The slope of (x1, y1, z1 and their rates) by eqs. (3), with the charges of eqs. (7) and (18)."""
    C1, C2, k_c = C1/Omega/Omega, C2/Omega, k_c/Omega/Omega
    Q_ref = eq07(1.0, k_c, m1, m2, L_ref)

    def slope(state):
        x1, y1, z1, x1_dot, y1_dot, z1_dot = state
        L = eq13(m1, m2, x1, y1, z1)
        L_dot = ((m1 + m2)/m2)**2*(x1*x1_dot + y1*y1_dot + z1*z1_dot)/L
        Q = Q_ref + eq18(k_c, m1, m2, L_ref, C1, C2, L - L_ref, L_dot)
        return (x1_dot, y1_dot, z1_dot) + eq03(1.0, k_c, m1, m2, Q, *state)
    return slope


def in_radians(Omega, motion, slope, state, *times):
    """Let a motion run in units in which Omega = 1, from a state in SI units to one in SI units."""
    state = motion(slope, [*state[:3], *(rate/Omega for rate in state[3:])], *(Omega*t for t in times))
    return [*state[:3], *(Omega*rate for rate in state[3:])]


def along(y, h, slope):
    return [a + h*b for a, b in zip(y, slope)]


STEPS = 2, 4, 6, 8, 12, 16, 24, 32, 48  # Bulirsch's: extrapolation magnifies roundings ninefold, not a hundredfold


def midpoint(slope, y, h, n):
    """How far y moves during h, by n steps of the modified midpoint rule."""
    h /= n
    before, now = [0.0]*len(y), [h*s for s in slope(y)]
    for _ in range(n - 1):
        before, now = now, along(before, 2*h, slope(along(y, 1, now)))
    return [(a + b + h*s)/2 for a, b, s in zip(before, now, slope(along(y, 1, now)))]


def extrapolated(slope, y, tau):
    """Gragg, Bulirsch and Stoer: the midpoint rule with ever more steps, extrapolated to infinitely many."""
    now, h = 0.0, copysign(0.25, tau)
    while now != tau:
        last = abs(tau - now) <= abs(h)
        h = tau - now if last else h
        rows = []
        for k, n in enumerate(STEPS):
            row = [midpoint(slope, y, h, n)]
            for j in range(1, k + 1):
                row.append([a + (a - b)/((n/STEPS[k - j])**2 - 1) for a, b in zip(row[-1], rows[-1][j - 1])])
            rows.append(row)
            if k and dist(row[-1], row[-2]) <= 1e-14*hypot(*y):
                y = along(y, 1, row[-1])
                now = tau if last else now + h
                h *= 1.5 if k < 6 else 1
                break
        else:
            h /= 2
            if now + h == now:
                raise OverflowError("the motion cannot be followed")
    return y


def runge_kutta(slope, y, t, h):
    """t/h steps of the classical method."""
    for _ in range(round(t/h)):
        k1 = slope(y)
        k2 = slope(along(y, h/2, k1))
        k3 = slope(along(y, h/2, k2))
        k4 = slope(along(y, h, k3))
        y = [a + h/6*(s1 + 2*s2 + 2*s3 + s4) for a, s1, s2, s3, s4 in zip(y, k1, k2, k3, k4)]
    return y


def flow_linear(Omega, L_ref, C1, C2, t, psi, theta, dL, psi_dot, theta_dot, dL_dot):
    """Pitch is an oscillator of its own, eq. (40a), which would outlast what decays; the rest is integrated."""
    slope = linear_model(Omega, L_ref, C1, C2)
    psi, _, dL, psi_dot, _, dL_dot = in_radians(
        Omega, extrapolated, slope, (psi, 0.0, dL, psi_dot, 0.0, dL_dot), t)
    c, s = cos(2*Omega*t), sin(2*Omega*t)
    return psi, c*theta + s*theta_dot/(2*Omega), dL, psi_dot, c*theta_dot - 2*Omega*s*theta, dL_dot


def flow_nonlinear(Omega, k_c, m1, m2, L_ref, C1, C2, t, x1, y1, z1, *rates):
    return in_radians(Omega, extrapolated, nonlinear_model(Omega, k_c, m1, m2, L_ref, C1, C2), (x1, y1, z1, *rates), t)


def rk4_linear(Omega, L_ref, C1, C2, t, psi, theta, dL, psi_dot, theta_dot, dL_dot, h):
    require(t >= 0 and fmod(t, h) == 0)
    state = psi, theta, dL, psi_dot, theta_dot, dL_dot
    return in_radians(Omega, runge_kutta, linear_model(Omega, L_ref, C1, C2), state, t, h)


def rk4_nonlinear(Omega, k_c, m1, m2, L_ref, C1, C2, t, x1, y1, z1, x1_dot, y1_dot, z1_dot, h):
    require(t >= 0 and fmod(t, h) == 0)
    state = x1, y1, z1, x1_dot, y1_dot, z1_dot
    return in_radians(Omega, runge_kutta, nonlinear_model(Omega, k_c, m1, m2, L_ref, C1, C2), state, t, h)


# ---- the protocol ----

OPERATIONS = {name: function for name, function in globals().items() if name.startswith(("eq", "flow_", "rk4_"))}


def answer(operation, *words):
    if operation not in OPERATIONS:
        return "skip unknown operation"
    function = OPERATIONS[operation]
    symbols = [*signature(function).parameters]
    inputs = [float(word) for word in words]
    try:
        for symbol, x in zip_longest(symbols, inputs, fillvalue=symbols[-1]):
            require(isfinite(x) or symbol == "lambda_d")
            require(x > 0 or symbol not in POSITIVE)
        outputs = function(*inputs)
    except ValueError:
        return "invalid"
    except ArithmeticError as error:
        return f"skip {error}"
    return " ".join(map(repr, outputs if isinstance(outputs, (list, tuple)) else [outputs]))


for line in sys.stdin:
    operation, vector, *words = line.split()
    print(vector, answer(operation, *words))
