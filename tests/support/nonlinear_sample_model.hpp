// The sample model with hardening springs: a reduction whose basis is not called modes, and a polynomial.
//
// Ẽ = ½ (4 z₁² + 9 z₂²) + ¼ (z₁² + γ z₂²)², γ = 2: no cubic part; the right mass alone is a Duffing oscillator
// z₂'' + 9 z₂ + γ² z₂³ = f.
#pragma once
#include "support/sample_model.hpp"

namespace ritz::test {

model::Polynomial sample_polynomial();

model::Model nonlinear_sample_model();

/// The same with a cubature of two cells of rubber, which the right mass stretches along z; its training ends at 40 J.
model::Model cubature_sample_model();

/// The sample, and as a second body the one of hardening springs, elsewhere and of a name that is no plain link.
model::Model two_body_model();

}  // namespace ritz::test
