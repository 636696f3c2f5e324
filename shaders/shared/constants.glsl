// Named numbers of the shared text. KD_CONST(T) is `const T` in GLSL and `static constexpr T` in C++.

KD_CONST(int) KD_LEAF = 3;

// Why a ray's walk ended; one of these per pixel, never a silent wrong answer. Larger values are worse.
KD_CONST(int) KD_EXIT_MISS = 0;
KD_CONST(int) KD_EXIT_HIT = 1;
KD_CONST(int) KD_EXIT_STEP_CAP = 2;
KD_CONST(int) KD_EXIT_STACK_OVERFLOW = 3;
KD_CONST(int) KD_EXIT_INVALID_RAY = 4;

// How a walk decides between children and goes on.
KD_CONST(int) KD_RULES_ROBUST = 0;
KD_CONST(int) KD_RULES_AS_PUBLISHED = 1;  // the paper, section 2.3.2
KD_CONST(int) KD_RULES_FIRST_EDITION = 2; // Pharr & Humphreys, Physically Based Rendering, 2004, section 4.4

// Answers of the split rule.
KD_CONST(int) KD_VISIT_NEAR = 0;
KD_CONST(int) KD_VISIT_FAR = 1;
KD_CONST(int) KD_VISIT_BOTH = 2;

// Legs of a path that are not numbers of reflections.
KD_CONST(int) KD_LEG_PRIMARY = 0;
KD_CONST(int) KD_LEG_INDIRECT = -1;

// How an image goes on beyond its edges.
KD_CONST(int) KD_WRAP_REPEAT = 0;
KD_CONST(int) KD_WRAP_CLAMP = 1;
KD_CONST(int) KD_WRAP_MIRROR = 2;

KD_CONST(int) KD_LIGHT_POINT = 0;
KD_CONST(int) KD_LIGHT_DIRECTIONAL = 1;
KD_CONST(int) KD_LIGHT_SPOT = 2;

// How far, as a fraction of the farthest point of the scene from the ray's origin, the watertight test may see a ray from
// where it exactly is: shear and edge functions in single precision err by about 10u of that distance (u = 2^-24), the
// distance to a plane by another 4u, or 7u with GLSL's 2.5 ulp division. A cell this close to the ray is visited.
KD_CONST(real) KD_SLACK = real(1e-6);

// A direction component below this fraction of the largest one moves a ray less than a hundredth of the slack.
KD_CONST(real) KD_PARALLEL = real(1e-8);

// Relative error allowed to the t of two hits that may be one: gamma(3) = 3u/(1-3u) = 1.8e-7 and a division.
KD_CONST(real) KD_T_PADDING = real(4e-7);

// gamma(7): bound on the relative error of a point computed from barycentrics (Pharr et al., Physically Based
// Rendering, section 3.9).
KD_CONST(real) KD_GAMMA_7 = real(4.172327e-7);

// Least that a light's colour is divided by: finite for a light that lies on the surface.
KD_CONST(real) KD_LEAST_FALLOFF = real(1e-6);

// Largest t and coordinate magnitude of a valid ray; leaves room for the padding below overflow.
KD_CONST(real) KD_T_LIMIT = real(3e38);
KD_CONST(real) KD_COORDINATE_LIMIT = real(1.844e18);
