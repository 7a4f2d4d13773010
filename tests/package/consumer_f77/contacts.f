C SPDX-FileCopyrightText: The libhgrid developers
C SPDX-License-Identifier: BSD-3-Clause
C
C A user's FORTRAN 77 program: the version of the library and the two
C contacts among three spheres.
C
      PROGRAM CONTAC
      IMPLICIT DOUBLE PRECISION (A-H, O-Z)
      DIMENSION X(3), Y(3), Z(3), R(3), BOX(3), IPER(3)
      DIMENSION IPAIR(9), JPAIR(9)
      DATA X /0.0D0, 1.5D0, 3.0D0/, Y /3*0.0D0/, Z /3*0.0D0/
      DATA R /1.0D0, 0.8D0, 0.9D0/, BOX /3*0.0D0/, IPER /3*0/
      CALL HGFNEW (IH, 3, 0, 0.0D0, IPER, BOX, BOX, IERR)
      IF (IERR .NE. 0) STOP 1
      CALL HGDPRS (IH, 3, X, Y, Z, R, 9, NPR, IPAIR, JPAIR, IERR)
      IF (IERR .NE. 0) STOP 2
      CALL HGFVER (MAJOR, MINOR, IPATCH)
      WRITE (*, '(A, I1, A, I1, A, I1)') 'hgrid ', MAJOR, '.', MINOR,
     &  '.', IPATCH
      WRITE (*, '(I1, 1X, I1)') (IPAIR(K), JPAIR(K), K = 1, NPR)
      CALL HGFEND (IH, IERR)
      IF (IERR .NE. 0) STOP 3
      END
