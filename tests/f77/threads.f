C SPDX-FileCopyrightText: The libhgrid developers
C SPDX-License-Identifier: BSD-3-Clause
C
C Many calls at once from the threads of OpenMP, on one grid and on
C grids of their own: each call answers for its own particles, and each
C thread reads its own text.
C
      PROGRAM THRDS
      COMMON /COUNT/ NBAD
      REAL*8 ZERO, BOX(3)
      INTEGER IPER(3)
      DATA IPER /0, 0, 0/, BOX /3*0.0D0/, ZERO /0.0D0/
      CALL HGFNEW (IHALL, 3, 0, ZERO, IPER, BOX, BOX, IERR)
      IF (IERR .NE. 0) STOP 1
C$OMP PARALLEL DO NUM_THREADS(8) SCHEDULE(DYNAMIC) PRIVATE(IH, IERR)
      DO 10 K = 1, 400
        CALL TRY (IHALL, MOD(K, 50) + 2)
        CALL HGFNEW (IH, 3, 0, ZERO, IPER, BOX, BOX, IERR)
        IF (IERR .NE. 0) CALL BAD
        CALL TRY (IH, MOD(K, 30) + 2)
        CALL HGFEND (IH, IERR)
        IF (IERR .NE. 0) CALL BAD
        CALL TEXTS (-K)
   10 CONTINUE
C$OMP END PARALLEL DO
      CALL HGFEND (IHALL, IERR)
      IF (IERR .NE. 0 .OR. NBAD .NE. 0) STOP 2
      END
C
C A row of N spheres, each of which meets the next one.
C
      RECURSIVE SUBROUTINE TRY (IH, N)
      REAL*8 X(60), Y(60), R(60)
      INTEGER IPAIR(60), JPAIR(60), POINT(61), LIST(60)
      DO 10 I = 1, N
        X(I) = I
        Y(I) = 0
        R(I) = 0.6D0
   10 CONTINUE
      CALL HGDPRS (IH, N, X, Y, Y, R, 60, NPR, IPAIR, JPAIR, IERR)
      IF (IERR .NE. 0 .OR. NPR .NE. N - 1) CALL BAD
      CALL HGDLST (IH, N, X, Y, Y, R, 60, POINT, LIST, IERR)
      IF (IERR .NE. 0 .OR. POINT(N + 1) .NE. N) CALL BAD
      DO 20 I = 1, N - 1
        IF (IPAIR(I) .NE. I .OR. JPAIR(I) .NE. I + 1) CALL BAD
        IF (POINT(I) .NE. I .OR. LIST(I) .NE. I + 1) CALL BAD
   20 CONTINUE
      END
C
C The text of a failure of this thread names its own number.
C
      RECURSIVE SUBROUTINE TEXTS (IH)
      CHARACTER*60 TEXT, WANTED
      CALL HGFEND (IH, IERR)
      IF (IERR .NE. 1) CALL BAD
      CALL HGFMSG (TEXT)
      WRITE (WANTED, '(A, I0, A)') 'HGFEND: IH = ', IH, ' is no grid'
      IF (TEXT(1:LEN_TRIM(WANTED)) .NE. WANTED) CALL BAD
      END
C
      SUBROUTINE BAD
      COMMON /COUNT/ NBAD
C$OMP ATOMIC
      NBAD = NBAD + 1
      END
C
      BLOCK DATA NONE
      COMMON /COUNT/ NBAD
      DATA NBAD /0/
      END
