C SPDX-FileCopyrightText: The libhgrid developers
C SPDX-License-Identifier: BSD-3-Clause
C
C A dam breaks: smoothed particles in two dimensions, fluid and wall,
C in single precision, their state in COMMON, as such codes were
C written. Arguments: [COUNT [STEPS]], the count of rows of fluid.
C Prints where each particle ends, with all digits; on standard error,
C the seconds that the search and the whole took.
C
      PROGRAM DAM
      PARAMETER (MAXP = 400000, MAXPR = 8000000)
      COMMON /PART/ X(MAXP), Y(MAXP), VX(MAXP), VY(MAXP), RHO(MAXP),
     &              HSM(MAXP), ITYPE(MAXP), N
      COMMON /PAIRS/ IPAIR(MAXPR), JPAIR(MAXPR), NPAIR
      COMMON /CONST/ G, C0, RHO0, PMASS, DT
      INTEGER*8 IT0, IT1, IT2, ISEA, IRATE
      NROW = NUMARG (1, 60)
      NSTEP = NUMARG (2, 1500)
      CALL SETUP (NROW)
      ISEA = 0
      CALL SYSTEM_CLOCK (IT0, IRATE)
      DO 10 ISTEP = 1, NSTEP
        CALL SYSTEM_CLOCK (IT1)
        CALL SEARCH
        CALL SYSTEM_CLOCK (IT2)
        ISEA = ISEA + IT2 - IT1
        CALL FORCES
        IF (MOD(ISTEP, 50) .NE. 0) GO TO 10
        CALL FRONT (XFRONT)
        WRITE (*, 100) ISTEP, XFRONT
   10 CONTINUE
      CALL SYSTEM_CLOCK (IT1)
      WRITE (0, 200) DBLE(ISEA)/IRATE, DBLE(IT1 - IT0)/IRATE
      WRITE (*, 300) (X(I), Y(I), RHO(I), I = 1, N)
  100 FORMAT ('STEP ', I6, ': FRONT AT ', E16.9)
  200 FORMAT ('search ', F0.3, ' s, all ', F0.3, ' s')
  300 FORMAT (3E18.9)
      END
C
C The K-th argument of the command, or IDEF.
C
      INTEGER FUNCTION NUMARG (K, IDEF)
      CHARACTER*20 ARG
      NUMARG = IDEF
      CALL GETARG (K, ARG)
      IF (ARG .NE. ' ') READ (ARG, *) NUMARG
      END
C
C A square of water, one metre high, in a tank three metres long.
C
      SUBROUTINE SETUP (NROW)
      PARAMETER (MAXP = 400000)
      COMMON /PART/ X(MAXP), Y(MAXP), VX(MAXP), VY(MAXP), RHO(MAXP),
     &              HSM(MAXP), ITYPE(MAXP), N
      COMMON /CONST/ G, C0, RHO0, PMASS, DT
      IF (NROW .LT. 10 .OR. NROW .GT. 600) STOP 'COUNT: 10 TO 600'
      DX = 1.0/NROW
      N = 0
      DO 20 J = 1, NROW
        DO 10 I = 1, NROW
          CALL ADD (I*DX, J*DX, DX, 1)
   10   CONTINUE
   20 CONTINUE
      DO 40 K = 0, 1
        DO 30 I = -1, 3*NROW + 2
          CALL ADD (I*DX, -K*DX, DX, 0)
   30   CONTINUE
        DO 35 J = 1, 2*NROW
          CALL ADD (-K*DX, J*DX, DX, 0)
          CALL ADD (3 + (K + 1)*DX, J*DX, DX, 0)
   35   CONTINUE
   40 CONTINUE
      G = 9.81
      C0 = 10*SQRT(G)
      RHO0 = 1000
      PMASS = RHO0*DX**2
      DT = 0.15*1.3*DX/C0
      END
C
      SUBROUTINE ADD (XN, YN, DX, IT)
      PARAMETER (MAXP = 400000)
      COMMON /PART/ X(MAXP), Y(MAXP), VX(MAXP), VY(MAXP), RHO(MAXP),
     &              HSM(MAXP), ITYPE(MAXP), N
      N = N + 1
      X(N) = XN
      Y(N) = YN
      VX(N) = 0
      VY(N) = 0
      RHO(N) = 1000
      HSM(N) = 1.3*DX
      ITYPE(N) = IT
      END
C
C Lists the pairs I < J nearer to each other than H(I) + H(J). They
C ascend, so that sums are made in the same order whatever the cells.
C
      SUBROUTINE SEARCH
      PARAMETER (MAXP = 400000, MAXPR = 8000000)
      COMMON /PART/ X(MAXP), Y(MAXP), VX(MAXP), VY(MAXP), RHO(MAXP),
     &              HSM(MAXP), ITYPE(MAXP), N
      COMMON /PAIRS/ IPAIR(MAXPR), JPAIR(MAXPR), NPAIR
      INTEGER IPER(2)
      SAVE IH
      DATA IH, IPER /3*0/
      IF (IH .EQ. 0) CALL HGFNEW (IH, 2, 0, 1D-6, IPER, 0D0, 0D0, IERR)
      CALL HGSPRS (IH, N, X, Y, Y, HSM, MAXPR, NPAIR, IPAIR, JPAIR,
     &             IERR)
      IF (IERR .NE. 0) STOP 'NO PAIRS'
      END
C
C Cubic spline, Tait's equation, artificial viscosity; then one step.
C
      SUBROUTINE FORCES
      PARAMETER (MAXP = 400000, MAXPR = 8000000)
      COMMON /PART/ X(MAXP), Y(MAXP), VX(MAXP), VY(MAXP), RHO(MAXP),
     &              HSM(MAXP), ITYPE(MAXP), N
      COMMON /PAIRS/ IPAIR(MAXPR), JPAIR(MAXPR), NPAIR
      COMMON /CONST/ G, C0, RHO0, PMASS, DT
      COMMON /RATES/ AX(MAXP), AY(MAXP), DRHO(MAXP), PRR(MAXP)
      PI = 3.14159265
      B = C0**2*RHO0/7
      DO 10 I = 1, N
        AX(I) = 0
        AY(I) = -G
        DRHO(I) = 0
        PRR(I) = B*((RHO(I)/RHO0)**7 - 1)/RHO(I)**2
   10 CONTINUE
      DO 20 K = 1, NPAIR
        I = IPAIR(K)
        J = JPAIR(K)
        DX = X(I) - X(J)
        DY = Y(I) - Y(J)
        RR = DX**2 + DY**2
        IF (RR .GE. (HSM(I) + HSM(J))**2) GO TO 20
        IF (ITYPE(I) + ITYPE(J) .EQ. 0) GO TO 20
        H = 0.5*(HSM(I) + HSM(J))
        Q = SQRT(RR)/H
        IF (Q .LT. 1) THEN
          DW = -3 + 2.25*Q
        ELSE
          DW = -0.75*(2 - Q)**2/Q
        END IF
        DW = PMASS*DW*10/(7*PI*H**4)
        VR = (VX(I) - VX(J))*DX + (VY(I) - VY(J))*DY
        F = PRR(I) + PRR(J)
        IF (VR .LT. 0) F = F - 0.1*C0*H*VR/(RR + 0.01*H**2)
     &                         *2/(RHO(I) + RHO(J))
        AX(I) = AX(I) - F*DW*DX
        AY(I) = AY(I) - F*DW*DY
        AX(J) = AX(J) + F*DW*DX
        AY(J) = AY(J) + F*DW*DY
        DRHO(I) = DRHO(I) + VR*DW
        DRHO(J) = DRHO(J) + VR*DW
   20 CONTINUE
      DO 30 I = 1, N
        RHO(I) = MAX(RHO0, RHO(I) + DT*DRHO(I))
        VX(I) = VX(I) + DT*AX(I)*ITYPE(I)
        VY(I) = VY(I) + DT*AY(I)*ITYPE(I)
        X(I) = X(I) + DT*VX(I)
        Y(I) = Y(I) + DT*VY(I)
   30 CONTINUE
      END
C
C How far the water has come along the floor.
C
      SUBROUTINE FRONT (XFRONT)
      PARAMETER (MAXP = 400000)
      COMMON /PART/ X(MAXP), Y(MAXP), VX(MAXP), VY(MAXP), RHO(MAXP),
     &              HSM(MAXP), ITYPE(MAXP), N
      XFRONT = 0
      DO 10 I = 1, N
        IF (ITYPE(I) .EQ. 1) XFRONT = MAX(XFRONT, X(I))
   10 CONTINUE
      END
