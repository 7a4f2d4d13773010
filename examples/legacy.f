C SPDX-FileCopyrightText: The libhgrid developers
C SPDX-License-Identifier: BSD-3-Clause
C
C A particle code as written for FORTRAN 77, its state in COMMON, that
C takes its neighbour lists from libhgrid. Only the module GRDMOD and
C the subroutines GRDINI and GRDNBR know the library, all the rest is
C plain FORTRAN 77.
C
C The grid outlives the calls that use it, so it stands in a module,
C beside the array that brings the three coordinates together.
C
      MODULE GRDMOD
      USE HGRID, ONLY: HG_GRID
      IMPLICIT NONE
      TYPE(HG_GRID), SAVE :: GRID
      DOUBLE PRECISION, ALLOCATABLE, SAVE :: POS(:, :)
      END MODULE GRDMOD
C
      PROGRAM LEGACY
      INTEGER MAXP, NSTEP
      PARAMETER (MAXP = 1000, NSTEP = 5)
      INTEGER NP
      DOUBLE PRECISION X, Y, Z, RAD, VX, VY, VZ
      COMMON /PARTCL/ X(MAXP), Y(MAXP), Z(MAXP), RAD(MAXP)
      COMMON /VELOC/ VX(MAXP), VY(MAXP), VZ(MAXP)
      COMMON /COUNTS/ NP
      INTEGER ISTEP, NC
      DOUBLE PRECISION DT, OVL
      DT = 0.02D0
      CALL SETUP
      CALL GRDINI
      DO 10 ISTEP = 1, NSTEP
        CALL ADVANC (DT)
        CALL GRDNBR (NC, OVL)
        WRITE (*, 100) ISTEP, NC, OVL
   10 CONTINUE
  100 FORMAT ('step ', I0, ': ', I0, ' contacts, sum of overlaps ',
     &        F0.6)
      END
C
C Ten layers of large and small spheres that fly apart or together.
C
      SUBROUTINE SETUP
      INTEGER MAXP
      PARAMETER (MAXP = 1000)
      INTEGER NP
      DOUBLE PRECISION X, Y, Z, RAD, VX, VY, VZ
      COMMON /PARTCL/ X(MAXP), Y(MAXP), Z(MAXP), RAD(MAXP)
      COMMON /VELOC/ VX(MAXP), VY(MAXP), VZ(MAXP)
      COMMON /COUNTS/ NP
      INTEGER I, J, K
      NP = 0
      DO 30 K = 1, 10
        DO 20 J = 1, 10
          DO 10 I = 1, 10
            NP = NP + 1
            X(NP) = I
            Y(NP) = J
            Z(NP) = K
            RAD(NP) = 0.1D0
            IF (MOD(I + J + K, 3) .EQ. 0) RAD(NP) = 0.8D0
            VX(NP) = MOD(7*NP, 11) - 5
            VY(NP) = MOD(5*NP, 13) - 6
            VZ(NP) = MOD(3*NP, 7) - 3
   10     CONTINUE
   20   CONTINUE
   30 CONTINUE
      END
C
      SUBROUTINE ADVANC (DT)
      DOUBLE PRECISION DT
      INTEGER MAXP
      PARAMETER (MAXP = 1000)
      INTEGER NP
      DOUBLE PRECISION X, Y, Z, RAD, VX, VY, VZ
      COMMON /PARTCL/ X(MAXP), Y(MAXP), Z(MAXP), RAD(MAXP)
      COMMON /VELOC/ VX(MAXP), VY(MAXP), VZ(MAXP)
      COMMON /COUNTS/ NP
      INTEGER I
      DO 10 I = 1, NP
        X(I) = X(I) + DT*VX(I)
        Y(I) = Y(I) + DT*VY(I)
        Z(I) = Z(I) + DT*VZ(I)
   10 CONTINUE
      END
C
C Hands the particles to the grid, once.
C
      SUBROUTINE GRDINI
      USE HGRID
      USE GRDMOD
      INTEGER MAXP
      PARAMETER (MAXP = 1000)
      INTEGER NP
      DOUBLE PRECISION X, Y, Z, RAD
      COMMON /PARTCL/ X(MAXP), Y(MAXP), Z(MAXP), RAD(MAXP)
      COMMON /COUNTS/ NP
      ALLOCATE (POS(3, NP))
      CALL GATHER
      CALL GRID%CREATE()
      CALL GRID%INSERT(POS, RAD(1:NP))
      END
C
      SUBROUTINE GATHER
      USE GRDMOD
      INTEGER MAXP
      PARAMETER (MAXP = 1000)
      INTEGER NP
      DOUBLE PRECISION X, Y, Z, RAD
      COMMON /PARTCL/ X(MAXP), Y(MAXP), Z(MAXP), RAD(MAXP)
      COMMON /COUNTS/ NP
      INTEGER I
      DO 10 I = 1, NP
        POS(1, I) = X(I)
        POS(2, I) = Y(I)
        POS(3, I) = Z(I)
   10 CONTINUE
      END
C
C Moves the particles to where they are now and adds up the overlaps.
C The neighbours J > I of I are NBR(K), K = OFF(I) + 1 ... OFF(I + 1).
C
      SUBROUTINE GRDNBR (NC, OVL)
      USE HGRID
      USE GRDMOD
      INTEGER NC
      DOUBLE PRECISION OVL
      INTEGER MAXP
      PARAMETER (MAXP = 1000)
      INTEGER NP
      DOUBLE PRECISION X, Y, Z, RAD
      COMMON /PARTCL/ X(MAXP), Y(MAXP), Z(MAXP), RAD(MAXP)
      COMMON /COUNTS/ NP
      INTEGER(C_INT64_T), POINTER :: OFF(:)
      INTEGER(C_INT32_T), POINTER :: NBR(:)
      INTEGER I, J
      INTEGER(C_INT64_T) K
      CALL GATHER
      CALL GRID%MOVE(POS)
      CALL GRID%QUERY_NEIGHBORS(HG_HALF, OFF, NBR)
      NC = SIZE(NBR)
      OVL = 0.0D0
      DO 20 I = 1, NP
        DO 10 K = OFF(I) + 1, OFF(I + 1)
          J = NBR(K)
          OVL = OVL + RAD(I) + RAD(J) - SQRT((X(I) - X(J))**2
     &        + (Y(I) - Y(J))**2 + (Z(I) - Z(J))**2)
   10   CONTINUE
   20 CONTINUE
      END
