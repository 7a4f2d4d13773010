C SPDX-FileCopyrightText: The libhgrid developers
C SPDX-License-Identifier: BSD-3-Clause
C
C The oracle: every two particles compared in whole numbers below
C 2**21, whose squares and sums double precision holds exactly.
C Lengths are these numbers times UNIT, which REAL*4 holds exactly.
C
C Makes N particles in the cube 0 <= KX < KEDGE, few of them large.
C
      SUBROUTINE SCENE (ISEED, N)
      PARAMETER (MAXN = 600)
      COMMON /WHOLE/ KX(3, MAXN), KR(MAXN), KEDGE, KMARG
      DOUBLE PRECISION S
      S = ISEED
      DO 20 I = 1, N
        DO 10 K = 1, 3
          CALL RANDOM (S, KEDGE/4096, KX(K, I))
          KX(K, I) = 4096*KX(K, I)
   10   CONTINUE
        CALL RANDOM (S, 16, KR(I))
        IF (MOD(I, 20) .NE. 0) KR(I) = KR(I)/4
        KR(I) = 4096*KR(I)
   20 CONTINUE
      END
C
C A whole number from 0 to LIMIT - 1, by Park and Miller.
C
      SUBROUTINE RANDOM (S, LIMIT, K)
      DOUBLE PRECISION S
      S = MOD(16807.0D0*S, 2147483647.0D0)
      K = INT(S*LIMIT/2147483647.0D0)
      END
C
C Whether I and J interact. MODE, IDIM and IPER as in HGFNEW; the box
C is the cube.
C
      LOGICAL FUNCTION MEET (I, J)
      PARAMETER (MAXN = 600)
      COMMON /WHOLE/ KX(3, MAXN), KR(MAXN), KEDGE, KMARG
      COMMON /RULE/ IDIM, MODE, IPER(3)
      DOUBLE PRECISION SQ, REACH
      SQ = 0
      DO 10 K = 1, IDIM
        KD = ABS(KX(K, I) - KX(K, J))
        IF (IPER(K) .EQ. 1) KD = MIN(KD, KEDGE - KD)
        SQ = SQ + DBLE(KD)*DBLE(KD)
   10 CONTINUE
      KREACH = KR(I) + KR(J)
      IF (MODE .EQ. 1) KREACH = MAX(KR(I), KR(J))
      REACH = KREACH + KMARG
      MEET = SQ .LT. REACH*REACH
      END
C
C The pairs are those of the oracle, in ascending order.
C
      SUBROUTINE CHKPRS (N, NPR, IPAIR, JPAIR, WHAT)
      CHARACTER*(*) WHAT
      LOGICAL MEET, SAME
      INTEGER IPAIR(*), JPAIR(*)
      NEXT = 1
      SAME = .TRUE.
      DO 20 I = 1, N - 1
        DO 10 J = I + 1, N
          IF (.NOT. MEET(I, J)) GO TO 10
          IF (NEXT .GT. NPR) THEN
            SAME = .FALSE.
          ELSE
            SAME = SAME .AND. IPAIR(NEXT) .EQ. I
     &           .AND. JPAIR(NEXT) .EQ. J
          END IF
          NEXT = NEXT + 1
   10   CONTINUE
   20 CONTINUE
      CALL CHECK (SAME .AND. NEXT .EQ. NPR + 1, WHAT)
      END
C
C The rows LIST(POINT(I)), ..., LIST(POINT(I + 1) - 1) are those of the
C oracle, J > I and ascending.
C
      SUBROUTINE CHKLST (N, POINT, LIST, WHAT)
      CHARACTER*(*) WHAT
      LOGICAL MEET, SAME
      INTEGER POINT(*), LIST(*)
      NEXT = 1
      SAME = .TRUE.
      DO 20 I = 1, N
        SAME = SAME .AND. POINT(I) .EQ. NEXT
        DO 10 J = I + 1, N
          IF (.NOT. MEET(I, J)) GO TO 10
          IF (NEXT .GE. POINT(N + 1)) THEN
            SAME = .FALSE.
          ELSE
            SAME = SAME .AND. LIST(NEXT) .EQ. J
          END IF
          NEXT = NEXT + 1
   10   CONTINUE
   20 CONTINUE
      CALL CHECK (SAME .AND. NEXT .EQ. POINT(N + 1), WHAT)
      END
C
      SUBROUTINE CHECK (HOLDS, WHAT)
      LOGICAL HOLDS
      CHARACTER*(*) WHAT
      COMMON /CHECKS/ NFAIL
      IF (HOLDS) RETURN
      NFAIL = NFAIL + 1
      WRITE (*, *) 'failed: ', WHAT
      END
C
      SUBROUTINE FINISH
      COMMON /CHECKS/ NFAIL
      IF (NFAIL .GT. 0) STOP 1
      END
C
      BLOCK DATA START
      PARAMETER (MAXN = 600)
      COMMON /WHOLE/ KX(3, MAXN), KR(MAXN), KEDGE, KMARG
      COMMON /CHECKS/ NFAIL
      DATA KEDGE /1048576/, KMARG /0/, NFAIL /0/
      END
