! The equations of a Coulomb tether formation in Fortran, as a client of the oracle:
!
!     gfortran -O2 -o client tests/clients/client.f90
!     coulomb-tether conform -- ./client
!
! A function bears the number of its equation, its arguments the paper's symbols, in SI units;
! r1, v1, a1 are the position, velocity and acceleration of craft 1 in the Hill frame.

module coulomb_tether
    use, intrinsic :: iso_fortran_env, only: dp => real64
    implicit none

contains

    ! ---- the static formation ----

    ! (2) any number of craft, the columns of x: mass, charge, position, velocity; charges shielded by the plasma
    pure function eq02(Omega, k_c, lambda_d, x) result(a)
        real(dp), intent(in) :: Omega, k_c, lambda_d, x(:, :)
        real(dp) :: a(3, size(x, 2)), away(3), d
        integer :: i, j

        do i = 1, size(x, 2)
            a(:, i) = hill(Omega, x(3:5, i), x(6:8, i))
            do j = 1, size(x, 2)
                if (j == i) cycle
                away = x(3:5, i) - x(3:5, j)
                d = norm2(away)
                a(:, i) = a(:, i) + k_c/x(1, i)*x(2, i)*x(2, j)*exp(-d/lambda_d)/d**3*away
            end do
        end do
    end function

    ! (2), (3) without charges
    pure function hill(Omega, r, v) result(a)
        real(dp), intent(in) :: Omega, r(3), v(3)
        real(dp) :: a(3)

        a = [2*Omega*v(2) + 3*Omega**2*r(1), -2*Omega*v(1), -Omega**2*r(3)]
    end function

    ! (3) craft 1 of a pair
    pure function eq03(Omega, k_c, m1, m2, Q, r1, v1) result(a1)
        real(dp), intent(in) :: Omega, k_c, m1, m2, Q, r1(3), v1(3)
        real(dp) :: a1(3)

        a1 = hill(Omega, r1, v1) + k_c/m1*Q/eq13(m1, m2, r1)**3*(r1 - eq04(m1, m2, r1))
    end function

    pure function eq04(m1, m2, r1) result(r2)
        real(dp), intent(in) :: m1, m2, r1(3)
        real(dp) :: r2(3)

        r2 = -m1/m2*r1
    end function

    pure function eq05(m1, m2, L) result(x)
        real(dp), intent(in) :: m1, m2, L
        real(dp) :: x(2)

        x = [m2, -m1]/(m1 + m2)*L
    end function

    pure real(dp) function eq07(Omega, k_c, m1, m2, L) result(Q_ref)
        real(dp), intent(in) :: Omega, k_c, m1, m2, L

        Q_ref = -3*Omega**2*L**3/k_c*(m1*m2/(m1 + m2))
    end function

    ! ---- the perturbed formation ----

    pure function eq09(psi, theta) result(BO)
        real(dp), intent(in) :: psi, theta
        real(dp) :: BO(3, 3)

        BO(1, :) = [cos(theta)*cos(psi), cos(theta)*sin(psi), -sin(theta)]
        BO(2, :) = [-sin(psi), cos(psi), 0.0_dp]
        BO(3, :) = [sin(theta)*cos(psi), sin(theta)*sin(psi), cos(theta)]
    end function

    ! (10) the exact rotation of (8)
    pure function eq10(m1, m2, L, psi, theta) result(r1)
        real(dp), intent(in) :: m1, m2, L, psi, theta
        real(dp) :: r1(3), BO(3, 3)

        BO = eq09(psi, theta)
        r1 = m2/(m1 + m2)*L*BO(1, :)
    end function

    pure function eq10lin(m1, m2, L, psi, theta) result(r1)
        real(dp), intent(in) :: m1, m2, L, psi, theta
        real(dp) :: r1(3)

        r1 = m2/(m1 + m2)*L*[1.0_dp, psi, -theta]
    end function

    ! (10) the other way. Zero added makes +0 of -0: psi is pi, not -pi, behind the origin, and 0 on the orbit normal.
    pure function eq10inv(m1, m2, r1) result(c)
        real(dp), intent(in) :: m1, m2, r1(3)
        real(dp) :: c(3)

        c = [eq13(m1, m2, r1), atan2(r1(2) + 0.0_dp, r1(1) + 0.0_dp), atan2(-r1(3), norm2(r1(1:2)))]
    end function

    ! (11) the exact derivative: the rates of the spherical coordinates along the directions in which they point
    pure function eq11exact(m1, m2, L, psi, theta, L_dot, psi_dot, theta_dot) result(v1)
        real(dp), intent(in) :: m1, m2, L, psi, theta, L_dot, psi_dot, theta_dot
        real(dp) :: v1(3), BO(3, 3)

        BO = eq09(psi, theta)
        v1 = m2/(m1 + m2)*(L_dot*BO(1, :) + L*psi_dot*cos(theta)*BO(2, :) - L*theta_dot*BO(3, :))
    end function

    pure function eq11(m1, m2, L, psi, theta, L_dot, psi_dot, theta_dot) result(v1)
        real(dp), intent(in) :: m1, m2, L, psi, theta, L_dot, psi_dot, theta_dot
        real(dp) :: v1(3)

        v1 = m2/(m1 + m2)*[L_dot, psi*L_dot + psi_dot*L, -theta*L_dot - theta_dot*L]
    end function

    pure real(dp) function eq12(r1, r2) result(L)
        real(dp), intent(in) :: r1(3), r2(3)

        L = norm2(r1 - r2)
    end function

    pure real(dp) function eq13(m1, m2, r1) result(L)
        real(dp), intent(in) :: m1, m2, r1(3)

        L = (m1 + m2)/m2*norm2(r1)
    end function

    ! (14) solved for L_ddot, where r^2 v^2 - (r . v)^2 = |r x v|^2
    pure real(dp) function eq14(Omega, k_c, m1, m2, Q, r1, v1) result(L_ddot)
        real(dp), intent(in) :: Omega, k_c, m1, m2, Q, r1(3), v1(3)
        real(dp) :: r, across(3)

        r = norm2(r1)
        across = (cshift(r1, 1)*cshift(v1, 2) - cshift(r1, 2)*cshift(v1, 1))/r
        L_ddot = (m1 + m2)/m2*(sum(across**2) + dot_product(r1, eq03(Omega, k_c, m1, m2, Q, r1, v1)))/r
    end function

    pure real(dp) function eq15(Omega, k_c, m1, m2, L, psi_dot, Q) result(L_ddot)
        real(dp), intent(in) :: Omega, k_c, m1, m2, L, psi_dot, Q

        L_ddot = (2*Omega*psi_dot + 3*Omega**2)*L + k_c/m1*Q/L**2*((m1 + m2)/m2)
    end function

    pure real(dp) function eq17(Omega, k_c, m1, m2, L_ref, psi_dot, dL, dQ) result(dL_ddot)
        real(dp), intent(in) :: Omega, k_c, m1, m2, L_ref, psi_dot, dL, dQ

        dL_ddot = 2*Omega*L_ref*psi_dot + 9*Omega**2*dL + k_c/m1/L_ref**2*((m1 + m2)/m2)*dQ
    end function

    ! ---- the control law ----

    pure real(dp) function eq18(k_c, m1, m2, L_ref, C1, C2, dL, dL_dot) result(dQ)
        real(dp), intent(in) :: k_c, m1, m2, L_ref, C1, C2, dL, dL_dot

        dQ = m1*m2*L_ref**2/((m1 + m2)*k_c)*(-C1*dL - C2*dL_dot)
    end function

    pure real(dp) function eq19(Omega, L_ref, C1, C2, dL, dL_dot, psi_dot) result(dL_ddot)
        real(dp), intent(in) :: Omega, L_ref, C1, C2, dL, dL_dot, psi_dot

        dL_ddot = -(C1 - 9*Omega**2)*dL - C2*dL_dot + 2*Omega*L_ref*psi_dot
    end function

    ! (21) for attraction, Q_ref + dQ < 0; the absolute value in print would answer repulsion with attraction
    pure function eq21(Q_ref, dQ) result(q)
        real(dp), intent(in) :: Q_ref, dQ
        real(dp) :: q(2)

        q = [1, -1]*sqrt(-(Q_ref + dQ))
    end function

    ! ---- attitude ----

    pure function eq25(Omega, theta) result(w)
        real(dp), intent(in) :: Omega, theta
        real(dp) :: w(3)

        w = Omega*[-sin(theta), 0.0_dp, cos(theta)]
    end function

    pure function eq26(theta, psi_dot, theta_dot) result(w)
        real(dp), intent(in) :: theta, psi_dot, theta_dot
        real(dp) :: w(3)

        w = [-sin(theta)*psi_dot, theta_dot, cos(theta)*psi_dot]
    end function

    pure function eq27(Omega, theta, psi_dot, theta_dot) result(w)
        real(dp), intent(in) :: Omega, theta, psi_dot, theta_dot
        real(dp) :: w(3)

        w = eq26(theta, psi_dot, theta_dot) + eq25(Omega, theta)
    end function

    pure function eq28(Omega, theta, psi_dot, theta_dot) result(w)
        real(dp), intent(in) :: Omega, theta, psi_dot, theta_dot
        real(dp) :: w(3)

        w = [-Omega*theta, theta_dot, psi_dot + Omega]
    end function

    pure function eq29(Omega, theta_dot, theta_ddot, psi_ddot) result(w_dot)
        real(dp), intent(in) :: Omega, theta_dot, theta_ddot, psi_ddot
        real(dp) :: w_dot(3)

        w_dot = [-Omega*theta_dot, theta_ddot, psi_ddot]
    end function

    ! (30) with m2 in the second term, where the print repeats m1; the upper triangle by rows
    pure function eq30(m1, m2, r1, r2) result(I)
        real(dp), intent(in) :: m1, m2, r1(3), r2(3)
        real(dp) :: I(6)

        I = m1*minus_tilde_squared(r1) + m2*minus_tilde_squared(r2)
    end function

    pure function minus_tilde_squared(r) result(t)
        real(dp), intent(in) :: r(3)
        real(dp) :: t(6)

        t = [r(2)**2 + r(3)**2, -r(1)*r(2), -r(1)*r(3), r(1)**2 + r(3)**2, -r(2)*r(3), r(1)**2 + r(2)**2]
    end function

    pure real(dp) function eq32(m1, m2, L) result(I)
        real(dp), intent(in) :: m1, m2, L

        I = m1*m2/(m1 + m2)*L**2
    end function

    pure real(dp) function eq34(m1, m2, L, L_dot) result(I_dot)
        real(dp), intent(in) :: m1, m2, L, L_dot

        I_dot = 2*(m1*m2/(m1 + m2))*L*L_dot
    end function

    pure function eq36(R_c, psi, theta) result(R)
        real(dp), intent(in) :: R_c, psi, theta
        real(dp) :: R(3), BO(3, 3)

        BO = eq09(psi, theta)
        R = R_c*BO(:, 1)
    end function

    ! (37) with the inertia of (31): 0, I, I
    pure function eq37(GM, R, I) result(L_G)
        real(dp), intent(in) :: GM, R(3), I
        real(dp) :: L_G(3)

        L_G = 3*GM/norm2(R)**5*R(1)*I*[0.0_dp, -R(3), R(2)]
    end function

    ! (38) is Kepler's third law; the factor of 3 in print is that of (37) and (39)
    pure real(dp) function eq38(GM, R_c) result(Omega)
        real(dp), intent(in) :: GM, R_c

        Omega = sqrt(GM/R_c**3)
    end function

    pure function eq39(Omega, I, psi, theta) result(L_G)
        real(dp), intent(in) :: Omega, I, psi, theta
        real(dp) :: L_G(3)

        L_G = -3*Omega**2*I*[0.0_dp, theta, psi]
    end function

    ! ---- the linear model and its stability ----

    ! (40) theta_ddot, psi_ddot, dL_ddot
    pure function eq40(Omega, L_ref, C1, C2, psi, theta, dL, dL_dot, psi_dot) result(a)
        real(dp), intent(in) :: Omega, L_ref, C1, C2, psi, theta, dL, dL_dot, psi_dot
        real(dp) :: a(3)

        a = [-4*Omega**2*theta, &
             -2*Omega/L_ref*dL_dot - 3*Omega**2*psi, &
             eq19(Omega, L_ref, C1, C2, dL, dL_dot, psi_dot)]
    end function

    pure function eq41(Omega, C1, C2) result(a)
        real(dp), intent(in) :: Omega, C1, C2
        real(dp) :: a(0:4)

        a = [3*Omega**2*(C1 - 9*Omega**2), 3*C2*Omega**2, C1 - 2*Omega**2, C2, 1.0_dp]
    end function

    ! (41) all roots at once, by Aberth's method: Newton's on the quotient of p and the other roots' factors.
    ! In units of Omega, where the coefficients are near one.
    pure function eq41roots(Omega, C1, C2) result(z)
        real(dp), intent(in) :: Omega, C1, C2
        real(dp) :: a(0:4)
        complex(dp) :: z(4), newton, step
        logical :: others(4), moving
        integer :: i, iteration

        a = eq41(1.0_dp, C1/Omega/Omega, C2/Omega)
        z = (1 + maxval(abs(a)))*exp((0.0_dp, 1.0_dp)*[(0.4_dp + 1.6_dp*i, i=1, 4)])
        moving = .true.
        do iteration = 1, 500
            if (.not. moving) exit
            moving = .false.
            do i = 1, 4
                newton = (((z(i) + a(3))*z(i) + a(2))*z(i) + a(1))*z(i) + a(0)
                if (newton == 0) cycle
                newton = newton/(((4*z(i) + 3*a(3))*z(i) + 2*a(2))*z(i) + a(1))
                others = z /= z(i)
                step = newton/(1 - newton*sum(1/(z(i) - z), mask=others))
                z(i) = z(i) - step
                moving = moving .or. abs(step) > epsilon(1.0_dp)*abs(z(i))
            end do
        end do
        z = sorted(Omega*z)
    end function

    ! by real part, then by imaginary part
    pure function sorted(z) result(s)
        complex(dp), intent(in) :: z(:)
        complex(dp) :: s(size(z)), low
        integer :: i, j

        s = z
        do i = 2, size(s)
            low = s(i)
            do j = i - 1, 1, -1
                if (s(j)%re < low%re .or. (s(j)%re == low%re .and. s(j)%im <= low%im)) exit
                s(j + 1) = s(j)
            end do
            s(j + 1) = low
        end do
    end function

    ! (42) what each gain has to spare, and 1 where both have something
    pure function eq42(Omega, C1, C2) result(margins)
        real(dp), intent(in) :: Omega, C1, C2
        real(dp) :: margins(3)

        margins = [C1 - 9*Omega**2, C2, 0.0_dp]
        if (all(margins(1:2) > 0)) margins(3) = 1
    end function

    pure real(dp) function eq43(Omega, n) result(C1)
        real(dp), intent(in) :: Omega, n

        C1 = n*Omega**2
    end function

    pure real(dp) function eq44(Omega, n) result(C2)
        real(dp), intent(in) :: Omega, n

        C2 = 2*Omega*sqrt(n - 9)
    end function

end module coulomb_tether

program client
    use, intrinsic :: iso_fortran_env, only: input_unit, output_unit
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan
    use coulomb_tether
    implicit none

    ! A letter for each input says what it may be:
    ! '+' positive, '0' not negative, '.' any finite number, 'i' positive or infinite.
    type :: operation
        character(16) :: id
        character(32) :: domain
    end type

    type(operation), parameter :: operations(*) = [ &
        operation('eq02', '++i+.......+.......+.......'), &
        operation('eq03', '++++.......'), operation('eq04', '++...'), operation('eq05', '+++'), &
        operation('eq07', '+++++'), operation('eq09', '..'), operation('eq10', '+++..'), &
        operation('eq10lin', '+++..'), operation('eq10inv', '++...'), operation('eq11exact', '+++.....'), &
        operation('eq11', '+++.....'), operation('eq12', '......'), operation('eq13', '++...'), &
        operation('eq14', '++++.......'), operation('eq15', '+++++..'), operation('eq17', '+++++...'), &
        operation('eq18', '++++....'), operation('eq19', '++.....'), operation('eq21', '..'), &
        operation('eq25', '+.'), operation('eq26', '...'), operation('eq27', '+...'), operation('eq28', '+...'), &
        operation('eq29', '+...'), operation('eq30', '++......'), operation('eq32', '+++'), &
        operation('eq34', '+++.'), operation('eq36', '+..'), operation('eq37', '+...0'), operation('eq38', '++'), &
        operation('eq39', '+0..'), operation('eq40', '++.......'), operation('eq41', '+..'), &
        operation('eq41roots', '+..'), operation('eq42', '+..'), operation('eq43', '++'), operation('eq44', '+.')]

    character(4096) :: line
    character(512) :: id, vector
    integer :: status

    do
        read (input_unit, '(a)', iostat=status) line
        if (status /= 0) exit
        read (line, *) id, vector
        write (output_unit, '(a)', advance='no') trim(vector)
        call answer(line, findloc(operations%id, id, dim=1))
    end do

contains

    subroutine answer(line, number)
        character(*), intent(in) :: line
        integer, intent(in) :: number
        character(512) :: id, vector
        character(:), allocatable :: domain
        real(dp), allocatable :: x(:), y(:)
        integer :: i

        if (number == 0) then
            write (output_unit, '(a)') ' skip unknown operation'
            return
        end if

        domain = trim(operations(number)%domain)
        allocate (x(len(domain)), y(0))
        read (line, *) id, vector, x
        if (all(inside([(domain(i:i), i=1, size(x))], x))) y = outputs(trim(id), x)

        if (size(y) == 0) then
            write (output_unit, '(a)') ' invalid'
        else if (any(ieee_is_nan(y))) then
            write (output_unit, '(a)') ' skip no convergence'
        else
            write (output_unit, '(*(1x, g0))') y
        end if
    end subroutine

    elemental logical function inside(letter, x)
        character, intent(in) :: letter
        real(dp), intent(in) :: x

        select case (letter)
        case ('+'); inside = x > 0 .and. ieee_is_finite(x)
        case ('0'); inside = x >= 0 .and. ieee_is_finite(x)
        case ('i'); inside = x > 0
        case default; inside = ieee_is_finite(x)
        end select
    end function

    ! Empty where inputs are outside the domain together, though each is inside by itself.
    function outputs(id, x) result(y)
        character(len=*), intent(in) :: id
        real(dp), intent(in) :: x(:)
        real(dp), allocatable :: y(:)
        complex(dp) :: z(4)

        allocate (y(0))
        select case (id)
        case ('eq02')
            if (any(x(6:8) /= x(14:16)) .and. any(x(14:16) /= x(22:24)) .and. any(x(22:24) /= x(6:8))) &
                y = [eq02(x(1), x(2), x(3), reshape(x(4:27), [8, 3]))]
        case ('eq03'); if (any(x(6:8) /= 0)) y = eq03(x(1), x(2), x(3), x(4), x(5), x(6:8), x(9:11))
        case ('eq04'); y = eq04(x(1), x(2), x(3:5))
        case ('eq05'); y = eq05(x(1), x(2), x(3))
        case ('eq07'); y = [eq07(x(1), x(2), x(3), x(4), x(5))]
        case ('eq09'); y = [transpose(eq09(x(1), x(2)))]
        case ('eq10'); y = eq10(x(1), x(2), x(3), x(4), x(5))
        case ('eq10lin'); y = eq10lin(x(1), x(2), x(3), x(4), x(5))
        case ('eq10inv'); if (any(x(3:5) /= 0)) y = eq10inv(x(1), x(2), x(3:5))
        case ('eq11exact'); y = eq11exact(x(1), x(2), x(3), x(4), x(5), x(6), x(7), x(8))
        case ('eq11'); y = eq11(x(1), x(2), x(3), x(4), x(5), x(6), x(7), x(8))
        case ('eq12'); if (any(x(1:3) /= x(4:6))) y = [eq12(x(1:3), x(4:6))]
        case ('eq13'); if (any(x(3:5) /= 0)) y = [eq13(x(1), x(2), x(3:5))]
        case ('eq14'); if (any(x(6:8) /= 0)) y = [eq14(x(1), x(2), x(3), x(4), x(5), x(6:8), x(9:11))]
        case ('eq15'); y = [eq15(x(1), x(2), x(3), x(4), x(5), x(6), x(7))]
        case ('eq17'); y = [eq17(x(1), x(2), x(3), x(4), x(5), x(6), x(7), x(8))]
        case ('eq18'); y = [eq18(x(1), x(2), x(3), x(4), x(5), x(6), x(7), x(8))]
        case ('eq19'); y = [eq19(x(1), x(2), x(3), x(4), x(5), x(6), x(7))]
        case ('eq21'); if (x(1) + x(2) < 0) y = eq21(x(1), x(2))
        case ('eq25'); y = eq25(x(1), x(2))
        case ('eq26'); y = eq26(x(1), x(2), x(3))
        case ('eq27'); y = eq27(x(1), x(2), x(3), x(4))
        case ('eq28'); y = eq28(x(1), x(2), x(3), x(4))
        case ('eq29'); y = eq29(x(1), x(2), x(3), x(4))
        case ('eq30'); y = eq30(x(1), x(2), x(3:5), x(6:8))
        case ('eq32'); y = [eq32(x(1), x(2), x(3))]
        case ('eq34'); y = [eq34(x(1), x(2), x(3), x(4))]
        case ('eq36'); y = eq36(x(1), x(2), x(3))
        case ('eq37'); if (any(x(2:4) /= 0)) y = eq37(x(1), x(2:4), x(5))
        case ('eq38'); y = [eq38(x(1), x(2))]
        case ('eq39'); y = eq39(x(1), x(2), x(3), x(4))
        case ('eq40'); y = eq40(x(1), x(2), x(3), x(4), x(5), x(6), x(7), x(8), x(9))
        case ('eq41'); y = eq41(x(1), x(2), x(3))
        case ('eq41roots')
            z = eq41roots(x(1), x(2), x(3))
            y = [transpose(reshape([z%re, z%im], [4, 2]))]
        case ('eq42'); y = eq42(x(1), x(2), x(3))
        case ('eq43'); y = [eq43(x(1), x(2))]
        case ('eq44'); if (x(2) >= 9) y = [eq44(x(1), x(2))]
        end select
    end function

end program client
