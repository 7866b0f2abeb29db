## The equations of a Coulomb tether formation in Octave, as a client of the oracle:
##
##     coulomb-tether conform -- octave-cli --quiet --no-init-file tests/clients/client.m
##
## A function bears the number of its equation and takes the paper's symbols in SI units; r1, v1, a1 are the
## position, velocity and acceleration of craft 1. Where the functions are defined stands in a table at the end.

1;  # a script, not a file of functions

## ---- the static formation ----

function a = eq02(Omega, k_c, lambda_d, varargin)
  craft = reshape([varargin{:}], 8, []);  # a column for each: mass, charge, position, velocity
  m = craft(1,:);
  q = craft(2,:);
  r = craft(3:5,:);
  a = hill(Omega)*craft(3:8,:);
  for i = 1:columns(craft)
    others = setdiff(1:columns(craft), i);
    away = r(:,i) - r(:,others);
    d = norm(away, "columns");
    a(:,i) += away*(k_c/m(i)*q(i)*q(others).*exp(-d/lambda_d)./d.^3)';
  endfor
endfunction

## What makes accelerations of positions and velocities where there are no charges.
function A = hill(Omega)
  A = [Omega^2*diag([3 0 -1]), 2*Omega*[0 1 0; -1 0 0; 0 0 0]];
endfunction

function a1 = eq03(Omega, k_c, m1, m2, Q, x1, y1, z1, x1_dot, y1_dot, z1_dot)
  r1 = [x1; y1; z1];
  r2 = eq04(m1, m2, x1, y1, z1);
  a1 = hill(Omega)*[r1; x1_dot; y1_dot; z1_dot] + k_c/m1*(r1 - r2)/norm(r1 - r2)^3*Q;
endfunction

function r2 = eq04(m1, m2, x1, y1, z1)
  r2 = -m1/m2*[x1; y1; z1];
endfunction

function x = eq05(m1, m2, L)
  x = [m2, -m1]/(m1 + m2)*L;
endfunction

function Q_ref = eq07(Omega, k_c, m1, m2, L)
  Q_ref = -3*Omega^2*L^3/k_c*(m1*m2/(m1 + m2));
endfunction

## ---- the perturbed formation ----

function rows = eq09(psi, theta)
  BO = [cos(theta)*cos(psi), cos(theta)*sin(psi), -sin(theta)
        -sin(psi)          , cos(psi)           , 0
        sin(theta)*cos(psi), sin(theta)*sin(psi), cos(theta)];
  rows = BO';
endfunction

## The exact rotation: along the first body axis.
function r1 = eq10(m1, m2, L, psi, theta)
  r1 = m2/(m1 + m2)*L*eq09(psi, theta)(:,1);
endfunction

function r1 = eq10lin(m1, m2, L, psi, theta)
  r1 = m2/(m1 + m2)*L*[1, psi, -theta];
endfunction

## Zero is added to make 0 of -0: psi is pi, not -pi, behind the origin, and 0 on the orbit normal.
function c = eq10inv(m1, m2, x1, y1, z1)
  c = [eq13(m1, m2, x1, y1, z1), atan2(y1 + 0, x1 + 0), atan2(-z1, hypot(x1, y1))];
endfunction

## The exact derivative, along the body axes: the third one points where theta decreases.
function v1 = eq11exact(m1, m2, L, psi, theta, L_dot, psi_dot, theta_dot)
  v1 = m2/(m1 + m2)*eq09(psi, theta)*[L_dot; L*psi_dot*cos(theta); -L*theta_dot];
endfunction

function v1 = eq11(m1, m2, L, psi, theta, L_dot, psi_dot, theta_dot)
  v1 = m2/(m1 + m2)*[L_dot, psi*L_dot + psi_dot*L, -theta*L_dot - theta_dot*L];
endfunction

function L = eq12(x1, y1, z1, x2, y2, z2)
  L = norm([x1 y1 z1] - [x2 y2 z2]);
endfunction

function L = eq13(m1, m2, x1, y1, z1)
  L = (m1 + m2)/m2*norm([x1 y1 z1]);
endfunction

## Solved for L_ddot, where r^2 v^2 - (r.v)^2 = |r x v|^2.
function L_ddot = eq14(Omega, k_c, m1, m2, Q, x1, y1, z1, x1_dot, y1_dot, z1_dot)
  r1 = [x1; y1; z1];
  v1 = [x1_dot; y1_dot; z1_dot];
  a1 = eq03(Omega, k_c, m1, m2, Q, x1, y1, z1, x1_dot, y1_dot, z1_dot);
  L_ddot = (m1 + m2)/m2*(sumsq(cross(r1, v1)/norm(r1)) + dot(r1, a1))/norm(r1);
endfunction

function L_ddot = eq15(Omega, k_c, m1, m2, L, psi_dot, Q)
  L_ddot = (2*Omega*psi_dot + 3*Omega^2)*L + k_c/m1*Q/L^2*((m1 + m2)/m2);
endfunction

function dL_ddot = eq17(Omega, k_c, m1, m2, L_ref, psi_dot, dL, dQ)
  dL_ddot = 2*Omega*L_ref*psi_dot + 9*Omega^2*dL + k_c/m1/L_ref^2*((m1 + m2)/m2)*dQ;
endfunction

## ---- the control law ----

function dQ = eq18(k_c, m1, m2, L_ref, C1, C2, dL, dL_dot)
  dQ = m1*m2*L_ref^2/((m1 + m2)*k_c)*(-C1*dL - C2*dL_dot);
endfunction

function dL_ddot = eq19(Omega, L_ref, C1, C2, dL, dL_dot, psi_dot)
  dL_ddot = -(C1 - 9*Omega^2)*dL - C2*dL_dot + 2*Omega*L_ref*psi_dot;
endfunction

## Only where the craft are to attract each other: the absolute value in print makes attraction of repulsion.
function q = eq21(Q_ref, dQ)
  q = [1 -1]*sqrt(-(Q_ref + dQ));
endfunction

## ---- attitude ----

function w = eq25(Omega, theta)
  w = Omega*[-sin(theta), 0, cos(theta)];
endfunction

function w = eq26(theta, psi_dot, theta_dot)
  w = [-sin(theta) 0; 0 1; cos(theta) 0]*[psi_dot; theta_dot];
endfunction

function w = eq27(Omega, theta, psi_dot, theta_dot)
  w = eq26(theta, psi_dot + Omega, theta_dot);
endfunction

function w = eq28(Omega, theta, psi_dot, theta_dot)
  w = [-Omega*theta, theta_dot, psi_dot + Omega];
endfunction

function w_dot = eq29(Omega, theta_dot, theta_ddot, psi_ddot)
  w_dot = [-Omega*theta_dot, theta_ddot, psi_ddot];
endfunction

## -m [r~][r~] of each craft with its own mass, where the print has m1 twice.
function I = eq30(m1, m2, x1, y1, z1, x2, y2, z2)
  tilde = @(r) [0 -r(3) r(2); r(3) 0 -r(1); -r(2) r(1) 0];
  I = -m1*tilde([x1 y1 z1])^2 - m2*tilde([x2 y2 z2])^2;
  I = I([1 4 7 5 8 9]);
endfunction

function I = eq32(m1, m2, L)
  I = m1*m2/(m1 + m2)*L^2;
endfunction

function I_dot = eq34(m1, m2, L, L_dot)
  I_dot = 2*(m1*m2/(m1 + m2))*L*L_dot;
endfunction

function R = eq36(R_c, psi, theta)
  R = R_c*eq09(psi, theta)(1,:);
endfunction

## With the inertia of (31): 0, I, I.
function L_G = eq37(GM, R_c1, R_c2, R_c3, I)
  L_G = 3*GM/norm([R_c1 R_c2 R_c3])^5*I*R_c1*[0, -R_c3, R_c2];
endfunction

## Kepler's third law; the 3 in print is that of (37).
function Omega = eq38(GM, R_c)
  Omega = sqrt(GM/R_c^3);
endfunction

function L_G = eq39(Omega, I, psi, theta)
  L_G = -3*Omega^2*I*[0, theta, psi];
endfunction

## ---- the linear model and its stability ----

## theta_ddot, psi_ddot, dL_ddot
function a = eq40(Omega, L_ref, C1, C2, psi, theta, dL, dL_dot, psi_dot)
  a = [-4*Omega^2*theta, ...
       -2*Omega/L_ref*dL_dot - 3*Omega^2*psi, ...
       eq19(Omega, L_ref, C1, C2, dL, dL_dot, psi_dot)];
endfunction

function a = eq41(Omega, C1, C2)
  a = [3*Omega^2*(C1 - 9*Omega^2), 3*C2*Omega^2, C1 - 2*Omega^2, C2, 1];
endfunction

## In units of Omega, where the coefficients are near one. Eigenvalues first, then Newton's method on each.
function y = eq41roots(Omega, C1, C2)
  p = fliplr(eq41(1, C1/Omega/Omega, C2/Omega));
  z = roots(p);
  do
    next = z - polyval(p, z)./polyval(polyder(p), z);
    nearer = abs(polyval(p, next)) < abs(polyval(p, z))/2;
    z(nearer) = next(nearer);
  until ! any(nearer)
  y = Omega*sortrows([real(z), imag(z)])';
endfunction

function margins = eq42(Omega, C1, C2)
  margins = [C1 - 9*Omega^2, C2];
  margins(3) = all(margins > 0);
endfunction

function C1 = eq43(Omega, n)
  C1 = n*Omega^2;
endfunction

function C2 = eq44(Omega, n)
  C2 = 2*Omega*sqrt(n - 9);
endfunction

## ---- motions: lengths in units of L_ref, times in units in which Omega = 1 ----

## (40) as a matrix, of psi, theta, dL and their rates.
function A = linear_model(Omega, C1, C2)
  stiffness = diag([3, 4, C1/Omega/Omega - 9]);
  damping = [0 0 2; 0 0 0; -2 0 C2/Omega];
  A = [zeros(3), eye(3); -stiffness, -damping];
endfunction

## (3) for the vector R = (1 + m1/m2) r1 from craft to craft, and for its rate. With the charge product of (7)
## and (18) in it, Coulomb's constant and the masses drop out. A column is a state, and there may be many.
function slope = nonlinear_model(Omega, C1, C2)
  C1 = C1/Omega/Omega;
  C2 = C2/Omega;
  free = [zeros(3), eye(3); hill(1)];
  position = [zeros(3, 6); eye(3), zeros(3)];
  slope = @(y) free*y - tension(C1, C2, y(1:3,:), y(4:6,:)).*(position*y);
endfunction

## What pulls the craft together, over L.
function f = tension(C1, C2, R, R_dot)
  L = sqrt(sumsq(R));
  f = (3 + C1*(L - 1) + C2*sum(R.*R_dot)./L)./L.^3;
endfunction

function s = linear_units(Omega, L_ref)
  s = [1; 1; L_ref; Omega; Omega; Omega*L_ref];
endfunction

function s = nonlinear_units(Omega, m1, m2, L_ref)
  s = L_ref*m2/(m1 + m2)*[1; 1; 1; Omega; Omega; Omega];
endfunction

function y = flow_linear(Omega, L_ref, C1, C2, t, varargin)
  units = linear_units(Omega, L_ref);
  y = units.*(expm(linear_model(Omega, C1, C2)*(Omega*t))*(vertcat(varargin{:})./units));
endfunction

## Where the slope is linear, a step of the classical method adds the exponential's first terms.
function y = rk4_linear(Omega, L_ref, C1, C2, t, varargin)
  units = linear_units(Omega, L_ref);
  y = vertcat(varargin{1:6})./units;
  h = varargin{7};
  A = linear_model(Omega, C1, C2)*(Omega*h);
  step = A*(eye(6) + A/2*(eye(6) + A/3*(eye(6) + A/4)));
  for n = 1:round(t/h)
    y += step*y;
  endfor
  y .*= units;
endfunction

function y = flow_nonlinear(Omega, k_c, m1, m2, L_ref, C1, C2, t, varargin)
  units = nonlinear_units(Omega, m1, m2, L_ref);
  y = units.*collocate(nonlinear_model(Omega, C1, C2), vertcat(varargin{:})./units, Omega*t);
endfunction

function y = rk4_nonlinear(Omega, k_c, m1, m2, L_ref, C1, C2, t, varargin)
  units = nonlinear_units(Omega, m1, m2, L_ref);
  f = nonlinear_model(Omega, C1, C2);
  y = vertcat(varargin{1:6})./units;
  h = Omega*varargin{7};
  for n = 1:round(t/varargin{7})
    k1 = f(y);
    k2 = f(y + h/2*k1);
    k3 = f(y + h/2*k2);
    k4 = f(y + h*k3);
    y += h/6*(k1 + 2*k2 + 2*k3 + k4);
  endfor
  y .*= units;
endfunction

## Piece by piece, y is the Chebyshev series that obeys y' = f(y) in its nodes; Picard's iteration finds it.
function y = collocate(f, y, tau)
  degree = 20;
  x = cos(pi*(degree:-1:0)'/degree);
  T = @(x, k) cos(acos(x)*k);
  primitive = @(x) [x, x.^2/2, (T(x, 3:degree+1)./(3:degree+1) - T(x, 1:degree-1)./(1:degree-1))/2];
  coefficients = inv(T(x, 0:degree))';
  integral = coefficients*(primitive(x) - primitive(-1))';

  now = 0;
  h = sign(tau)/2;
  while now != tau
    if now + h == now  # the craft meet
      y(:) = NaN;
      return
    endif
    last = abs(tau - now) <= abs(h);
    if last
      h = tau - now;
    endif
    Y = y + zeros(1, degree + 1);
    for iteration = 1:40
      before = Y;
      Y = y + h/2*f(Y)*integral;
      if norm(Y - before, "fro") <= 8*eps*norm(y)
        break
      endif
    endfor
    if iteration < 40 && norm(Y*coefficients(:,end-2:end), "fro") <= 1e-15*norm(y)
      y = Y(:,end);
      now = ifelse(last, tau, now + h);
    else
      h /= 2;
    endif
  endwhile
endfunction

## ---- domains ----

## Inputs that have to be positive.
positive = struct( ...
  "eq02", [1:4 12 20], "eq03", 1:4, "eq04", 1:2, "eq05", 1:3, "eq07", 1:5, ...
  "eq09", [], "eq10", 1:3, "eq10lin", 1:3, "eq10inv", 1:2, "eq11exact", 1:3, "eq11", 1:3, ...
  "eq12", [], "eq13", 1:2, "eq14", 1:4, "eq15", 1:5, "eq17", 1:5, "eq18", 1:4, "eq19", 1:2, "eq21", [], ...
  "eq25", 1, "eq26", [], "eq27", 1, "eq28", 1, "eq29", 1, "eq30", 1:2, "eq32", 1:3, "eq34", 1:3, ...
  "eq36", 1, "eq37", 1, "eq38", 1:2, "eq39", 1, "eq40", 1:2, "eq41", 1, "eq41roots", 1, "eq42", 1, ...
  "eq43", 1:2, "eq44", 1, ...
  "flow_linear", 1:2, "flow_nonlinear", 1:5, "rk4_linear", [1:2 12], "rk4_nonlinear", [1:5 15]);

## What else has to hold.
further.eq02 = @(x) any(x(6:8) != x(14:16)) && any(x(14:16) != x(22:24)) && any(x(22:24) != x(6:8));
further.eq12 = @(x) any(x(1:3) != x(4:6));
further.eq10inv = further.eq13 = @(x) any(x(3:5));
further.eq03 = further.eq14 = @(x) any(x(6:8));
further.eq21 = @(x) x(1) + x(2) < 0;
further.eq37 = @(x) any(x(2:4)) && x(5) >= 0;
further.eq39 = @(x) x(2) >= 0;
further.eq44 = @(x) x(2) >= 9;
further.flow_nonlinear = @(x) any(x(9:11));
further.rk4_linear = @(x) whole_steps(x(5), x(12));
further.rk4_nonlinear = @(x) any(x(9:11)) && whole_steps(x(8), x(15));

## Whether t is n h exactly: n times half of h's digits is exact, and so is the difference. rem forgives a rounding.
function yes = whole_steps(t, h)
  n = round(t/h);
  upper = double(single(h));
  yes = t >= 0 && t - n*upper == n*(h - upper);
endfunction

## ---- the protocol ----

while ischar(line = fgetl(stdin))
  words = strsplit(strtrim(line));
  [id, vector] = words{1:2};
  if ! isfield(positive, id)
    printf("%s skip unknown operation\n", vector);
    continue
  endif
  x = str2double(words(3:end));
  unbounded = strcmp(id, "eq02") & 1:numel(x) == 3;  # lambda_d
  if ! (all(isfinite(x) | unbounded) && all(x(positive.(id)) > 0) && (! isfield(further, id) || further.(id)(x)))
    printf("%s invalid\n", vector);
    continue
  endif
  y = feval(id, num2cell(x){:});
  if any(isnan(y(:)))
    printf("%s skip no convergence\n", vector);
  else
    printf("%s%s\n", vector, sprintf(" %.17g", y));
  endif
endwhile
