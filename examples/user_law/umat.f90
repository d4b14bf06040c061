! SPDX-License-Identifier: BSD-3-Clause
! Linear elasticity with von Mises strength and linear isotropic hardening, as a UMAT.
! PROPS: Young's modulus; Poisson's ratio; strength in uniaxial compression; its increase per plastic strain.
! STATEV: accumulated plastic strain.
subroutine umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dtime, temp, dtemp, &
                predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, nprops, coords, drot, pnewdt, celent, dfgrd0, dfgrd1, &
                noel, npt, layer, kspt, kstep, kinc)
  implicit none
  integer, parameter :: dp = kind(1d0)
  character(len=80) :: cmname
  integer :: ndi, nshr, ntens, nstatv, nprops, noel, npt, layer, kspt, kstep, kinc
  real(dp) :: stress(ntens), statev(nstatv), ddsdde(ntens, ntens), sse, spd, scd, rpl, ddsddt(ntens), drplde(ntens), drpldt
  real(dp) :: stran(ntens), dstran(ntens), time(2), dtime, temp, dtemp, predef(1), dpred(1), props(nprops), coords(3), drot(3, 3)
  real(dp) :: pnewdt, celent, dfgrd0(3, 3), dfgrd1(3, 3)
  real(dp) :: shear, lame, bulk, size, strength, more, pressure, deviator(ntens), kept, direction(ntens), factor
  integer :: i, j

  shear = props(1) / (2 * (1 + props(2)))
  bulk = props(1) / (3 * (1 - 2 * props(2)))
  lame = bulk - 2 * shear / 3
  ddsdde = 0
  ddsdde(1:ndi, 1:ndi) = lame
  do i = 1, ntens
    ddsdde(i, i) = ddsdde(i, i) + merge(2 * shear, shear, i <= ndi)
  end do
  stress = stress + matmul(ddsdde, dstran)

  pressure = sum(stress(1:ndi)) / 3
  deviator = stress
  deviator(1:ndi) = stress(1:ndi) - pressure
  size = sqrt(1.5_dp * (sum(deviator(1:ndi)**2) + 2 * sum(deviator(ndi+1:ntens)**2)))
  strength = props(3) + props(4) * statev(1)
  if (size <= strength) return

  ! Radial return, and its consistent tangent.
  more = (size - strength) / (3 * shear + props(4))
  statev(1) = statev(1) + more
  kept = 1 - 3 * shear * more / size
  direction = 1.5_dp * deviator / size
  stress = kept * deviator
  stress(1:ndi) = stress(1:ndi) + pressure
  factor = 3 * shear * more / size - 3 * shear / (3 * shear + props(4))
  ddsdde = 0
  ddsdde(1:ndi, 1:ndi) = bulk - 2 * shear * kept / 3
  do i = 1, ntens
    ddsdde(i, i) = ddsdde(i, i) + merge(2 * shear, shear, i <= ndi) * kept
    do j = 1, ntens
      ddsdde(i, j) = ddsdde(i, j) + factor * (4 * shear / 3) * direction(i) * direction(j)
    end do
  end do
end subroutine umat
