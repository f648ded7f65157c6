// The one-term Ogden solid, incompressible here; impact/ has the compressible form that the solver uses.
//   W = (2 mu/alpha^2) (lambda_1^alpha + lambda_2^alpha + lambda_3^alpha - 3)      Guha 2009, Eq. 3-2
// mu is the small-strain shear modulus.
#pragma once

namespace percal {

struct Ogden {
  double mu;     // Pa
  double alpha;  // any real number; 0 is the limit W = mu (sum ln^2 lambda)
};

}  // namespace percal
