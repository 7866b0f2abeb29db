## The equations of a Coulomb tether formation in Octave, as a client of the oracle:
##
##     coulomb-tether conform -- octave-cli --quiet --no-init-file tests/clients/client.m
##
## A function bears the number of its equation and takes the paper's symbols in SI units. It answers many
## questions at once: an argument is a row with an element for each, a result has a column for each.
## r1, v1, a1 are the position, velocity and acceleration of craft 1 in the Hill frame.

1;  # a script, not a file of functions

## ---- the static formation ----

function a = eq02(Omega, k_c, lambda_d, varargin)
  craft = reshape(varargin, 8, []);
  a = [];
  for i = 1:columns(craft)
    [m, q, x, y, z, x_dot, y_dot, z_dot] = craft{:,i};
    a_i = hill(Omega, x, z, x_dot, y_dot);
    for j = setdiff(1:columns(craft), i)
      away = [x; y; z] - vertcat(craft{3:5,j});
      d = norm(away, "columns");
      a_i += k_c./m.*q.*craft{2,j}.*exp(-d./lambda_d)./d.^3.*away;
    endfor
    a = [a; a_i];
  endfor
endfunction

## (2), (3) where there are no charges.
function a = hill(Omega, x, z, x_dot, y_dot)
  a = [2*Omega.*y_dot + 3*Omega.^2.*x; -2*Omega.*x_dot; -Omega.^2.*z];
endfunction

function a1 = eq03(Omega, k_c, m1, m2, Q, x1, y1, z1, x1_dot, y1_dot, z1_dot)
  away = [x1; y1; z1] - eq04(m1, m2, x1, y1, z1);
  a1 = hill(Omega, x1, z1, x1_dot, y1_dot) + k_c./m1.*Q./norm(away, "columns").^3.*away;
endfunction

function r2 = eq04(m1, m2, x1, y1, z1)
  r2 = -m1./m2.*[x1; y1; z1];
endfunction

function x = eq05(m1, m2, L)
  x = [m2; -m1]./(m1 + m2).*L;
endfunction

function Q_ref = eq07(Omega, k_c, m1, m2, L)
  Q_ref = -3*Omega.^2.*L.^3./k_c.*(m1.*m2./(m1 + m2));
endfunction

## ---- the perturbed formation ----

## The three rows of the matrix, one below the other: the body axes in the orbit frame.
function BO = eq09(psi, theta)
  BO = [cos(theta).*cos(psi); cos(theta).*sin(psi); -sin(theta)
        -sin(psi)           ; cos(psi)            ; zeros(size(psi))
        sin(theta).*cos(psi); sin(theta).*sin(psi); cos(theta)];
endfunction

## The exact rotation.
function r1 = eq10(m1, m2, L, psi, theta)
  r1 = m2./(m1 + m2).*L.*eq09(psi, theta)(1:3,:);
endfunction

function r1 = eq10lin(m1, m2, L, psi, theta)
  r1 = m2./(m1 + m2).*L.*[ones(size(L)); psi; -theta];
endfunction

## Zero is added to make 0 of -0: psi is pi, not -pi, behind the origin, and 0 on the orbit normal.
function c = eq10inv(m1, m2, x1, y1, z1)
  c = [eq13(m1, m2, x1, y1, z1); atan2(y1 + 0, x1 + 0); atan2(-z1, hypot(x1, y1))];
endfunction

## The exact derivative, along the body axes: theta grows against the third one.
function v1 = eq11exact(m1, m2, L, psi, theta, L_dot, psi_dot, theta_dot)
  BO = eq09(psi, theta);
  v1 = m2./(m1 + m2).*(L_dot.*BO(1:3,:) + L.*psi_dot.*cos(theta).*BO(4:6,:) - L.*theta_dot.*BO(7:9,:));
endfunction

function v1 = eq11(m1, m2, L, psi, theta, L_dot, psi_dot, theta_dot)
  v1 = m2./(m1 + m2).*[L_dot; psi.*L_dot + psi_dot.*L; -theta.*L_dot - theta_dot.*L];
endfunction

function L = eq12(x1, y1, z1, x2, y2, z2)
  L = norm([x1; y1; z1] - [x2; y2; z2], "columns");
endfunction

function L = eq13(m1, m2, x1, y1, z1)
  L = (m1 + m2)./m2.*norm([x1; y1; z1], "columns");
endfunction

## Solved for L_ddot, where r^2 v^2 - (r.v)^2 = |r x v|^2.
function L_ddot = eq14(Omega, k_c, m1, m2, Q, x1, y1, z1, x1_dot, y1_dot, z1_dot)
  r1 = [x1; y1; z1];
  v1 = [x1_dot; y1_dot; z1_dot];
  a1 = eq03(Omega, k_c, m1, m2, Q, x1, y1, z1, x1_dot, y1_dot, z1_dot);
  r = norm(r1, "columns");
  L_ddot = (m1 + m2)./m2.*(sumsq(cross(r1, v1, 1)./r) + dot(r1, a1, 1))./r;
endfunction

function L_ddot = eq15(Omega, k_c, m1, m2, L, psi_dot, Q)
  L_ddot = (2*Omega.*psi_dot + 3*Omega.^2).*L + k_c./m1.*Q./L.^2.*((m1 + m2)./m2);
endfunction

function dL_ddot = eq17(Omega, k_c, m1, m2, L_ref, psi_dot, dL, dQ)
  dL_ddot = 2*Omega.*L_ref.*psi_dot + 9*Omega.^2.*dL + k_c./m1./L_ref.^2.*((m1 + m2)./m2).*dQ;
endfunction

## ---- the control law ----

function dQ = eq18(k_c, m1, m2, L_ref, C1, C2, dL, dL_dot)
  dQ = m1.*m2.*L_ref.^2./((m1 + m2).*k_c).*(-C1.*dL - C2.*dL_dot);
endfunction

function dL_ddot = eq19(Omega, L_ref, C1, C2, dL, dL_dot, psi_dot)
  dL_ddot = -(C1 - 9*Omega.^2).*dL - C2.*dL_dot + 2*Omega.*L_ref.*psi_dot;
endfunction

## For attraction alone: the absolute value in print would make attraction of a command to repel.
function q = eq21(Q_ref, dQ)
  q = [1; -1].*sqrt(-(Q_ref + dQ));
endfunction

## ---- attitude ----

function w = eq25(Omega, theta)
  w = Omega.*[-sin(theta); zeros(size(theta)); cos(theta)];
endfunction

function w = eq26(theta, psi_dot, theta_dot)
  w = [-sin(theta).*psi_dot; theta_dot; cos(theta).*psi_dot];
endfunction

function w = eq27(Omega, theta, psi_dot, theta_dot)
  w = eq26(theta, psi_dot + Omega, theta_dot);
endfunction

function w = eq28(Omega, theta, psi_dot, theta_dot)
  w = [-Omega.*theta; theta_dot; psi_dot + Omega];
endfunction

function w_dot = eq29(Omega, theta_dot, theta_ddot, psi_ddot)
  w_dot = [-Omega.*theta_dot; theta_ddot; psi_ddot];
endfunction

## Each craft with its own mass, where the print has m1 twice. The upper triangle, row by row.
function I = eq30(m1, m2, x1, y1, z1, x2, y2, z2)
  inertia = @(m, x, y, z) m.*[y.^2 + z.^2; -x.*y; -x.*z; x.^2 + z.^2; -y.*z; x.^2 + y.^2];
  I = inertia(m1, x1, y1, z1) + inertia(m2, x2, y2, z2);
endfunction

function I = eq32(m1, m2, L)
  I = m1.*m2./(m1 + m2).*L.^2;
endfunction

function I_dot = eq34(m1, m2, L, L_dot)
  I_dot = 2*(m1.*m2./(m1 + m2)).*L.*L_dot;
endfunction

function R = eq36(R_c, psi, theta)
  R = R_c.*eq09(psi, theta)([1 4 7],:);
endfunction

## With the inertia of (31): 0, I, I.
function L_G = eq37(GM, R_c1, R_c2, R_c3, I)
  R_c = norm([R_c1; R_c2; R_c3], "columns");
  L_G = 3*GM./R_c.^5.*I.*R_c1.*[zeros(size(I)); -R_c3; R_c2];
endfunction

## Kepler's third law; the 3 in print is that of (37).
function Omega = eq38(GM, R_c)
  Omega = sqrt(GM./R_c.^3);
endfunction

function L_G = eq39(Omega, I, psi, theta)
  L_G = -3*Omega.^2.*I.*[zeros(size(I)); theta; psi];
endfunction

## ---- the linear model and its stability ----

## theta_ddot, psi_ddot, dL_ddot
function a = eq40(Omega, L_ref, C1, C2, psi, theta, dL, dL_dot, psi_dot)
  a = [-4*Omega.^2.*theta
       -2*Omega./L_ref.*dL_dot - 3*Omega.^2.*psi
       eq19(Omega, L_ref, C1, C2, dL, dL_dot, psi_dot)];
endfunction

function a = eq41(Omega, C1, C2)
  a = [3*Omega.^2.*(C1 - 9*Omega.^2); 3*C2.*Omega.^2; C1 - 2*Omega.^2; C2; ones(size(C2))];
endfunction

## In units of Omega, where the coefficients are near one. Eigenvalues first, then Newton's method on each.
function y = eq41roots(Omega, C1, C2)
  p = flipud(eq41(1, C1/Omega/Omega, C2/Omega))';
  z = roots(p);
  do
    next = z - polyval(p, z)./polyval(polyder(p), z);
    nearer = abs(polyval(p, next)) < abs(polyval(p, z))/2;
    z(nearer) = next(nearer);
  until ! any(nearer)
  y = Omega*sortrows([real(z), imag(z)])'(:);
endfunction

function margins = eq42(Omega, C1, C2)
  margins = [C1 - 9*Omega.^2; C2];
  margins(3,:) = all(margins > 0);
endfunction

function C1 = eq43(Omega, n)
  C1 = n.*Omega.^2;
endfunction

function C2 = eq44(Omega, n)
  C2 = 2*Omega.*sqrt(n - 9);
endfunction

## ---- motions: lengths in units of L_ref, times in units in which Omega = 1 ----

## (40) as a matrix, of psi, theta, dL and their rates.
function A = linear_model(Omega, C1, C2)
  stiffness = diag([3, 4, C1/Omega/Omega - 9]);
  damping = [0 0 2; 0 0 0; -2 0 C2/Omega];
  A = [zeros(3), eye(3); -stiffness, -damping];
endfunction

function s = linear_units(Omega, L_ref)
  s = [1; 1; L_ref; Omega; Omega; Omega*L_ref];
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

## (3) for R = (1 + m1/m2) r1, the vector from craft to craft, and its rate. With the charge product of (7)
## and (18) in it, Coulomb's constant and the masses drop out.
function slope = nonlinear_model(Omega, C1, C2)
  C1 = C1./Omega./Omega;
  C2 = C2./Omega;
  free = [zeros(3), eye(3); 3 0 0 0 2 0; 0 0 0 -2 0 0; 0 0 -1 0 0 0];
  position = [zeros(3, 6); eye(3), zeros(3)];
  slope = @(y) free*y - tension(C1, C2, y(1:3,:), y(4:6,:)).*(position*y);
endfunction

## What pulls the craft together, over L.
function f = tension(C1, C2, R, R_dot)
  L = sqrt(sumsq(R));
  f = (3 + C1.*(L - 1) + C2.*sum(R.*R_dot)./L)./L.^3;
endfunction

function s = nonlinear_units(Omega, m1, m2, L_ref)
  s = L_ref.*m2./(m1 + m2).*[ones(3, columns(Omega)); repmat(Omega, 3, 1)];
endfunction

function y = flow_nonlinear(Omega, k_c, m1, m2, L_ref, C1, C2, t, varargin)
  units = nonlinear_units(Omega, m1, m2, L_ref);
  y = units.*collocate(nonlinear_model(Omega, C1, C2), vertcat(varargin{:})./units, Omega*t);
endfunction

## The classical method on all motions side by side, each noted after its own number of steps.
function y = rk4_nonlinear(Omega, k_c, m1, m2, L_ref, C1, C2, t, varargin)
  units = nonlinear_units(Omega, m1, m2, L_ref);
  y = now = vertcat(varargin{1:6})./units;
  f = nonlinear_model(Omega, C1, C2);
  h = Omega.*varargin{7};
  steps = round(t./varargin{7});
  for n = 1:max(steps)
    k1 = f(now);
    k2 = f(now + h/2.*k1);
    k3 = f(now + h/2.*k2);
    k4 = f(now + h.*k3);
    now += h/6.*(k1 + 2*k2 + 2*k3 + k4);
    y(:, n == steps) = now(:, n == steps);
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
further.eq02 = @(x) any(x(6:8,:) != x(14:16,:)) & any(x(14:16,:) != x(22:24,:)) & any(x(22:24,:) != x(6:8,:));
further.eq12 = @(x) any(x(1:3,:) != x(4:6,:));
further.eq10inv = further.eq13 = @(x) any(x(3:5,:));
further.eq03 = further.eq14 = @(x) any(x(6:8,:));
further.eq21 = @(x) x(1,:) + x(2,:) < 0;
further.eq37 = @(x) any(x(2:4,:)) & x(5,:) >= 0;
further.eq39 = @(x) x(2,:) >= 0;
further.eq44 = @(x) x(2,:) >= 9;
further.flow_nonlinear = @(x) any(x(9:11,:));
further.rk4_linear = @(x) whole_steps(x(5,:), x(12,:));
further.rk4_nonlinear = @(x) any(x(9:11,:)) & whole_steps(x(8,:), x(15,:));

## Whether t is n h exactly: n times half of h's digits is exact, and so is the difference. rem forgives a rounding.
function yes = whole_steps(t, h)
  n = round(t./h);
  upper = double(single(h));
  yes = t >= 0 & t - n.*upper == n.*(h - upper);
endfunction

function yes = inside(id, x, positive, further)
  finite = isfinite(x);
  if strcmp(id, "eq02")
    finite(3,:) = true;  # lambda_d
  endif
  yes = all(finite, 1) & all(x(positive.(id),:) > 0, 1);
  if isfield(further, id)
    yes(yes) = further.(id)(x(:,yes));
  endif
endfunction

## ---- the protocol: all questions are read, then answered an operation at a time ----

function replies = answer(id, x, inside)
  replies = repmat({" invalid"}, 1, columns(x));
  rows = num2cell(x(:,inside), 2);
  if ! any(inside)
    return
  elseif any(strcmp(id, {"eq41roots", "flow_linear", "flow_nonlinear", "rk4_linear"}))
    y = cell2mat(arrayfun(id, rows{:}, "UniformOutput", false));
  else
    y = feval(id, rows{:});
  endif
  replies(inside) = cellfun(@(y) sprintf(" %.17g", y), num2cell(y, 1), "UniformOutput", false);
  replies(find(inside)(any(isnan(y), 1))) = {" skip no convergence"};
endfunction

questions = regexp(strsplit(fread(stdin, Inf, "char=>char")', "\n"), '\S+', "match");
questions = questions(! cellfun(@isempty, questions));
ids = cellfun(@(words) words{1}, questions, "UniformOutput", false);
replies = repmat({" skip unknown operation"}, size(ids));
for id = fieldnames(positive)'
  asked = strcmp(ids, id{1});
  if any(asked)
    words = vertcat(questions{asked})';
    x = reshape(str2double(words(3:end,:)), [], columns(words));
    replies(asked) = answer(id{1}, x, inside(id{1}, x, positive, further));
  endif
endfor
cellfun(@(words, reply) printf("%s%s\n", words{2}, reply), questions, replies);
