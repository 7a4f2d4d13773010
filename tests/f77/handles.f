C SPDX-FileCopyrightText: The libhgrid developers
C SPDX-License-Identifier: BSD-3-Clause
C
C Handles that are alive, dead or never were, and what HGFMSG tells of
C calls that fail. Two spheres overlap, the third stands apart.
C
      PROGRAM HANDLES
      COMMON /GRIDS/ IHA, IHB
      CALL TELLS ('before any failure', ' ')
      CALL REFUSE (0, 'IH = 0 is no grid')
      CALL REFUSE (1, 'IH = 1 is no grid')
      CALL REFUSE (-1, 'IH = -1 is no grid')
      CALL REFUSE (2147483647, 'IH = 2147483647 is no grid')
      CALL MAKE (IHA, 0.0D0)
      CALL MAKE (IHB, 5.0D0)
      CALL CHECK (IHA .NE. IHB .AND. IHA .NE. 0, 'two grids')
      CALL COUNTS (IHA, 1)
      CALL COUNTS (IHB, 3)
      CALL COUNTS (IHA, 1)
      CALL WRONG (IHA)
      CALL COUNTS (IHA, 1)
      ISAVED = IHA
      CALL HGFEND (IHA, IERR)
      CALL CHECK (IERR .EQ. 0 .AND. IHA .EQ. 0, 'HGFEND')
      CALL REFUSE (IHA, 'is no grid')
      CALL REFUSE (ISAVED, 'is no grid')
      CALL HGFEND (ISAVED, IERR)
      CALL CHECK (IERR .NE. 0, 'HGFEND of a dead grid')
      CALL HGFEND (7, IERR)
      CALL CHECK (IERR .NE. 0, 'HGFEND of a number that is no grid')
      CALL TELLS ('HGFEND', 'HGFEND: IH = 7 is no grid')
      CALL COUNTS (IHB, 3)
      CALL MAKE (IHA, 0.0D0)
      CALL CHECK (IHA .NE. ISAVED, 'numbers are not given out twice')
      CALL REFUSE (ISAVED, 'is no grid')
      CALL HGFEND (IHA, IERR)
      CALL HGFEND (IHB, IERR)
      CALL BADNEW
      CALL FINISH
      END
C
      SUBROUTINE MAKE (IH, MARGIN)
      REAL*8 MARGIN, BOX(3)
      INTEGER IPER(3)
      DATA IPER /0, 0, 0/, BOX /3*0.0D0/
      CALL HGFNEW (IH, 3, 0, MARGIN, IPER, BOX, BOX, IERR)
      CALL CHECK (IERR .EQ. 0, 'HGFNEW')
      END
C
C Without a box, without Z in two dimensions, and what is refused.
C
      SUBROUTINE BADNEW
      REAL*8 ZERO, LESS, LOW(2), HIGH(2), X(3), BAD(1), HUGE8
      INTEGER IPER(3), IPAIR(3), JPAIR(3)
      DATA ZERO /0.0D0/, LESS /-1.0D0/, HUGE8 /1.0D300/
      DATA LOW /2*0.0D0/, HIGH /2*-1.0D0/, X /3*1.0D0/
      DATA IPER /0, 1, 7/
      CALL HGFNEW (IH, 4, 0, ZERO, IPER, LOW, HIGH, IERR)
      CALL CHECK (IERR .EQ. 2 .AND. IH .EQ. 0, 'dimension 4')
      CALL TELLS ('dimension', 'HGFNEW: IDIM = 4')
      CALL HGFNEW (IH, -7, 0, ZERO, IPER, LOW, HIGH, IERR)
      CALL CHECK (IERR .EQ. 2 .AND. IH .EQ. 0, 'dimension -7')
      CALL HGFNEW (IH, 2, 5, ZERO, IPER, LOW, HIGH, IERR)
      CALL CHECK (IERR .EQ. 2 .AND. IH .EQ. 0, 'MODE 5')
      CALL TELLS ('mode', 'HGFNEW: MODE = 5')
      CALL HGFNEW (IH, 2, 0, LESS, IPER, LOW, HIGH, IERR)
      CALL CHECK (IERR .EQ. 2 .AND. IH .EQ. 0, 'MARGIN -1')
      CALL TELLS ('margin', 'HGFNEW: MARGIN = -1')
      CALL HGFNEW (IH, 2, 0, ZERO, IPER, LOW, HIGH, IERR)
      CALL CHECK (IERR .EQ. 2 .AND. IH .EQ. 0, 'a box inside out')
      CALL TELLS ('box', 'BOXMAX(2) = -1 is not above BOXMIN(2)')
      CALL HGFNEW (IH, 3, 0, ZERO, IPER(2), LOW, HIGH, IERR)
      CALL CHECK (IERR .EQ. 2 .AND. IH .EQ. 0, 'IPER 7')
      IPER(2) = 0
      CALL HGFNEW (IH, 2, 0, ZERO, IPER, LOW, HIGH, IERR)
      CALL CHECK (IERR .EQ. 0, 'open axes need no box')
      BAD(1) = HUGE8*HUGE8
      CALL HGDPRS (IH, 3, X, X, BAD, X, 3, NPR, IPAIR, JPAIR, IERR)
      CALL CHECK (IERR .EQ. 0 .AND. NPR .EQ. 3, 'no Z in the plane')
      CALL HGFEND (IH, IERR)
      CALL CHECK (IERR .EQ. 0, 'HGFEND in the plane')
      END
C
C A grid that must be there, and finds NEED pairs.
C
      SUBROUTINE COUNTS (IH, NEED)
      INTEGER IPAIR(3), JPAIR(3), POINT(4), LIST(3)
      REAL*8 X(3), Y(3), Z(3), R(3)
      COMMON /PLACES/ X, Y, Z, R
      CALL HGDPRS (IH, 3, X, Y, Z, R, 3, NPR, IPAIR, JPAIR, IERR)
      CALL CHECK (IERR .EQ. 0 .AND. NPR .EQ. NEED, 'pairs of a grid')
      CALL CHECK (IPAIR(1) .EQ. 1 .AND. JPAIR(1) .EQ. 2, '1 and 2')
      CALL HGDLST (IH, 3, X, Y, Z, R, 3, POINT, LIST, IERR)
      CALL CHECK (IERR .EQ. 0 .AND. POINT(4) .EQ. NEED + 1, 'lists')
      END
C
C A number that must not be taken for a grid: nothing is written.
C
      SUBROUTINE REFUSE (IH, WHY)
      CHARACTER*(*) WHY
      INTEGER IPAIR(3), JPAIR(3), POINT(4), LIST(3)
      REAL*8 X(3), Y(3), Z(3), R(3)
      COMMON /PLACES/ X, Y, Z, R
      DATA IPAIR, JPAIR, POINT, LIST /13*-9/
      NPR = 5
      CALL HGDPRS (IH, 3, X, Y, Z, R, 3, NPR, IPAIR, JPAIR, IERR)
      CALL CHECK (IERR .EQ. 1 .AND. NPR .EQ. 0, 'pairs of no grid')
      CALL TELLS ('no grid', WHY)
      CALL HGDLST (IH, 3, X, Y, Z, R, 3, POINT, LIST, IERR)
      CALL CHECK (IERR .EQ. 1, 'lists of no grid')
      DO 10 K = 1, 3
        CALL CHECK (IPAIR(K) .EQ. -9 .AND. JPAIR(K) .EQ. -9
     &   .AND. POINT(K) .EQ. -9 .AND. LIST(K) .EQ. -9, 'untouched')
   10 CONTINUE
      END
C
C Bad numbers are named as the program knows them.
C
      SUBROUTINE WRONG (IH)
      INTEGER IPAIR(3), JPAIR(3), POINT(4), LIST(3)
      REAL*8 X(3), Y(3), Z(3), R(3), Q(3), HUGE8
      COMMON /PLACES/ X, Y, Z, R
      DATA Q /1.0D0, 1.0D0, -2.5D0/, HUGE8 /1.0D300/
      CALL HGDPRS (IH, 3, X, Y, Z, Q, 3, NPR, IPAIR, JPAIR, IERR)
      CALL CHECK (IERR .EQ. 2 .AND. NPR .EQ. 0, 'a negative radius')
      CALL TELLS ('radius', 'HGDPRS: R(3) = -2.5 is negative')
      Q(2) = HUGE8*HUGE8
      CALL HGDLST (IH, 3, X, Q, Z, R, 3, POINT, LIST, IERR)
      CALL CHECK (IERR .EQ. 2, 'a place that is not finite')
      CALL TELLS ('place', 'HGDLST: Y(2) = inf is not finite')
      CALL HGDPRS (IH, -1, X, Y, Z, R, 3, NPR, IPAIR, JPAIR, IERR)
      CALL CHECK (IERR .EQ. 2, 'N -1')
      CALL TELLS ('number', 'HGDPRS: N = -1 is negative')
      CALL HGDPRS (IH, 3, X, Y, Z, R, -3, NPR, IPAIR, JPAIR, IERR)
      CALL CHECK (IERR .EQ. 2, 'MAXPR -3')
      CALL HGDLST (IH, 3, X, Y, Z, R, -3, POINT, LIST, IERR)
      CALL CHECK (IERR .EQ. 2, 'MAXNB -3')
      CALL TELLS ('capacity', 'HGDLST: MAXNB = -3 is negative')
      END
C
C HGFMSG begins with TEXT, in strings of any length, blanks behind it.
C
      SUBROUTINE TELLS (WHAT, TEXT)
      CHARACTER*(*) WHAT, TEXT
      CHARACTER*300 LONG
      CHARACTER*5 SHORT
      LONG = 'x'
      CALL HGFMSG (LONG)
      CALL CHECK (INDEX(LONG, TEXT) .GT. 0, WHAT)
      CALL CHECK (LONG(300:300) .EQ. ' ', 'blanks behind the text')
      CALL HGFMSG (SHORT)
      CALL CHECK (SHORT .EQ. LONG(1:5), 'a text that is cut')
      END
C
      BLOCK DATA PLACED
      REAL*8 X(3), Y(3), Z(3), R(3)
      COMMON /PLACES/ X, Y, Z, R
      DATA X /0.0D0, 1.0D0, 4.0D0/, Y /3*0.0D0/, Z /3*0.0D0/
      DATA R /3*0.75D0/
      END
