// Named numbers of the shared text. KD_CONST(T) is `const T` in GLSL and `static constexpr T` in C++.

KD_CONST(int) KD_LEAF = 3;

// Why a ray's walk ended; one of these per pixel, never a silent wrong answer. Larger values are worse.
KD_CONST(int) KD_EXIT_MISS = 0;
KD_CONST(int) KD_EXIT_HIT = 1;
KD_CONST(int) KD_EXIT_STEP_CAP = 2;
KD_CONST(int) KD_EXIT_STACK_OVERFLOW = 3;
KD_CONST(int) KD_EXIT_INVALID_RAY = 4;

// Answers of the split rule.
KD_CONST(int) KD_VISIT_NEAR = 0;
KD_CONST(int) KD_VISIT_FAR = 1;
KD_CONST(int) KD_VISIT_BOTH = 2;

KD_CONST(int) KD_LIGHT_POINT = 0;
KD_CONST(int) KD_LIGHT_DIRECTIONAL = 1;
KD_CONST(int) KD_LIGHT_SPOT = 2;

// Relative padding of every distance to a plane: above gamma(3) = 3u/(1-3u) = 1.8e-7 (u = 2^-24, Higham) plus the
// 2.5 ulp that GLSL allows a division.
KD_CONST(real) KD_T_PADDING = real(4e-7);

// gamma(7): bound on the relative error of a point computed from barycentrics (Pharr et al., Physically Based
// Rendering, section 3.9).
KD_CONST(real) KD_GAMMA_7 = real(4.172327e-7);

// Largest t and coordinate magnitude of a valid ray; leaves room for the padding below overflow.
KD_CONST(real) KD_T_LIMIT = real(3e38);
KD_CONST(real) KD_COORDINATE_LIMIT = real(1.844e18);
