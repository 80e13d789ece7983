// The elements and faces for which function templates are compiled: RITZ_ELEMENTS(F) is F(Tet4) F(Tet10) F(Hex8).
#pragma once
#include "ritz/fem/face.hpp"
#include "ritz/fem/hex8.hpp"
#include "ritz/fem/tet10.hpp"
#include "ritz/fem/tet4.hpp"

#define RITZ_ELEMENTS(F) F(Tet4) F(Tet10) F(Hex8)
#define RITZ_FACES(F) F(Tri3) F(Tri6) F(Quad4)
