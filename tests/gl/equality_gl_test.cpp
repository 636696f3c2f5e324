// The CPU and OpenGL run the same text: hits and counters agree bit for bit, on every layer.
#include <algorithm>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/scene/procedural.h"
#include "renderer/trace/counters.h"
#include "tests/gl/gl_test.h"

namespace kd {
namespace {

using test::context_name;
using test::ContextTest;
using test::whole;

/// Highlights use pow, which rounds differently on every machine (up to 51 ulp on llvmpipe); all else in a colour is
/// exact. 51 ulp of a highlight of at most 3 are 1.9e-5; what is seen is a tenth of it, 2.3e-6.
constexpr float colour_tolerance = 2e-5f;

/// A GPU may take log2 2^-21 off (GLSL 4.60, section 4.7.1), and some ten ulp of quotients and roots into the base of
/// the power. With the exponent 80 that is 2.6e-5 and 4.8e-5 of a highlight of at most 3: 2.2e-4, and twice that is
/// allowed.
constexpr float gpu_colour_tolerance = 5e-4f;

constexpr int width = 96;
constexpr int height = 64;

struct Case {
    ContextKind context;
    Traversal traversal;
    LeafLists lists;
    NodeEncoding nodes = NodeEncoding::float4;  // of OpenGL; the CPU's are float4
    GlMode mode = GlMode::fragment;
};

constexpr ContextKind contexts[] = {ContextKind::osmesa, ContextKind::egl};

/// `cases`: as many for one context as for the other. Fragment shaders get all of them; of many, the other modes get
/// every second one, in the other context the ones left out in this: both contexts compile with the same compiler here.
std::vector<Case> in_all_modes(const std::vector<Case>& cases) {
    std::vector<Case> all;
    const std::size_t half = cases.size() / 2;
    for (const GlMode mode : gl_modes)
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const bool has_its_turn = (i % half + i / half + std::size_t(mode)) % 2 == 0;
            if (mode != GlMode::fragment && half > 1 && !has_its_turn) continue;
            Case each = cases[i];
            each.mode = mode;
            if (has_walk(mode, {.traversal = each.traversal})) all.push_back(each);
        }
    return all;
}

/// The same for every kind of context.
std::vector<Case> all_cases() {
    std::vector<Case> cases;
    for (const ContextKind context : contexts)
        for (const TraversalInfo& traversal : traversals())
            for (const LeafLists lists : {LeafLists::references, LeafLists::duplicated})
                cases.push_back({context, traversal.id, lists});
    return in_all_modes(cases);
}

/// Compiling takes most of a test's time, so that what no traversal should matter to is tried with two, one a context.
std::vector<Case> two_cases() {
    return in_all_modes({{ContextKind::osmesa, Traversal::stack, LeafLists::references},
                         {ContextKind::egl, Traversal::backtrack, LeafLists::duplicated}});
}

std::vector<Case> each_traversal() {
    std::vector<Case> cases;
    for (const ContextKind context : contexts)
        for (const TraversalInfo& traversal : traversals())
            cases.push_back({context, traversal.id, LeafLists::references, NodeEncoding::packed});
    return in_all_modes(cases);
}

std::string case_name(const testing::TestParamInfo<Case>& test) {
    std::string name = std::string(name_of(test.param.context)) + "_" + std::string(info(test.param.traversal).name) +
                       (test.param.lists == LeafLists::duplicated ? "_duplicated" : "_references") +
                       (test.param.nodes == NodeEncoding::packed ? "_packed" : "") + "_" +
                       std::string(tracer_name(test.param.mode));
    std::ranges::replace(name, '-', '_');
    return name;
}

/// What differs between two frames.
struct Difference {
    std::array<int, pass_count> hits{}, triangles{}, counters{};  // pixels
    int colours = 0;                                              // pixels beyond the tolerance, or NaN
    float largest = 0;                                            // of a colour
};

Difference compare_frames(const Frame& a, const Frame& b, float tolerance) {
    Difference difference;
    for (std::size_t i = 0; i < a.colour.pixels.size(); ++i) {
        for (std::size_t pass = 0; pass < pass_count; ++pass) {
            if (!a.holds(Pass(pass)) && !b.holds(Pass(pass))) continue;
            const Hit& p = a.layers[pass].hit.pixels[i];
            const Hit& q = b.layers[pass].hit.pixels[i];
            difference.hits[pass] += !bit_equal(p, q);
            difference.triangles[pass] += p.triangle != q.triangle;
            difference.counters[pass] += !(a.layers[pass].counters.pixels[i] == b.layers[pass].counters.pixels[i]);
        }
        const Vec4 d = glm::abs(a.colour.pixels[i] - b.colour.pixels[i]);
        difference.largest = std::max({difference.largest, d.x, d.y, d.z, d.w});
        difference.colours += !(d.x <= tolerance && d.y <= tolerance && d.z <= tolerance && d.w <= tolerance);
    }
    return difference;
}

/// llvmpipe divides and takes roots as C++ does. GPUs may be 2.5 ulp off in a division (GLSL 4.60, section 4.7.1), but
/// for those that shaders/shared/rounding.glsl corrects: all that hits and counters come from. Colours have others as
/// well.
void expect_equal(const Frame& cpu, const Frame& gl, bool software) {
    ASSERT_EQ(cpu.width, gl.width);
    ASSERT_EQ(cpu.height, gl.height);
    const Difference d = compare_frames(cpu, gl, software ? colour_tolerance : gpu_colour_tolerance);
    for (std::size_t pass = 0; pass < pass_count; ++pass) {
        EXPECT_EQ(d.hits[pass], 0) << "hits of " << pass_names[pass];
        EXPECT_EQ(d.triangles[pass], 0) << "triangles of " << pass_names[pass];
        EXPECT_EQ(d.counters[pass], 0) << "counters of " << pass_names[pass];
    }
    EXPECT_EQ(d.colours, 0) << "by up to " << d.largest;
}

/// Interior nodes that the CPU's primary rays visit.
std::uint64_t primary_visits(const FlatScene& scene, const TraceConfig& config) {
    const KdTree tree = build_tree(scene.triangles, {});
    Frame frame(width, height);
    CpuTracer(scene, tree).trace_frame(config, pinhole(scene.camera, width, height), frame, 2);
    std::uint64_t sum = 0;
    for (const RayCounters& c : frame.layer(Pass::rt_prim).counters.pixels) sum += c.interior_first + c.interior_again;
    return sum;
}

class EqualityGl : public testing::TestWithParam<Case> {
  protected:
    void SetUp() override {
        try {
            context = Context::create(GetParam().context);
        } catch (const ContextError& error) {
            GTEST_SKIP() << "NO CONTEXT: " << error.what();
        }
        config.trace.traversal = GetParam().traversal;
        config.trace.leaf_lists = GetParam().lists;
    }

    void compare(const FlatScene& scene, const BuildConfig& build) { compare(scene, build, GetParam().nodes); }

    /// The CPU over nodes of 16 bytes, OpenGL over those asked for.
    void compare(const FlatScene& scene, const BuildConfig& build, NodeEncoding nodes) {
        const KdTree tree = build_tree(scene.triangles, build);
        const PinholeCamera camera = pinhole(scene.camera, width, height);
        Frame expected(width, height);
        CpuTracer(scene, tree).trace_frame(config.trace, camera, expected, 2);
        config.trace.nodes = nodes;
        GlTracer tracer(*context, GetParam().mode);
        tracer.upload(scene, tree);
        (void)tracer.draw(config, camera, width, height, whole(width, height));
        expect_equal(expected, tracer.read_frame(config.trace), context->is_software());
    }

    std::unique_ptr<Context> context;
    GlTraceConfig config;
};
INSTANTIATE_TEST_SUITE_P(All, EqualityGl, testing::ValuesIn(all_cases()), case_name);

class EqualityOfPassesGl : public EqualityGl {};
INSTANTIATE_TEST_SUITE_P(Two, EqualityOfPassesGl, testing::ValuesIn(two_cases()), case_name);

class EqualityOfWalksGl : public EqualityGl {};
INSTANTIATE_TEST_SUITE_P(Each, EqualityOfWalksGl, testing::ValuesIn(each_traversal()), case_name);

TEST_P(EqualityGl, OneBounce) {
    const bool naive = config.trace.traversal == Traversal::naive;
    compare(test::mirror_scene(naive ? 60 : 500, 7), {});
}

TEST_P(EqualityOfPassesGl, ThreeBouncesAsPublished) {
    config.trace.reflection_depth = 3;
    config.early_z = EarlyZ::as_published;
    compare(test::mirror_scene(100, 8), {});
}

TEST_P(EqualityOfPassesGl, ThreeBouncesCulled) {
    config.trace.reflection_depth = 3;
    compare(test::mirror_scene(100, 8), {});
}

TEST_P(EqualityOfPassesGl, LargeLeavesOfGlowingSurfacesWithoutShadows) {
    config.trace.shadows = false;
    FlatScene scene = test::mirror_scene(300, 9);
    Image<Rgba8> image(2, 1);
    image.pixels = {{255, 128, 0, 255}, {10, 200, 90, 255}};
    const int texture = add_texture(scene, plain_texture(image));
    for (Material& material : scene.materials) {
        material.emission = Vec3(0.1f, 0.9f, 1.5f);
        material.emission_texture = texture;
    }
    compare(scene, {.leaf_size = 16});
}

TEST_P(EqualityOfPassesGl, ImagesOfEveryKind) {
    // Leaves with holes, bent normals that mirrors follow, mip maps, clamped and mirrored images.
    FlatScene scene = flatten(*make_procedural("topiary:300"));
    for (Material& material : scene.materials)
        if (material.normal_texture >= 0) material.reflectance = Vec3(0.4f);
    config.trace.reflection_depth = 2;
    compare(scene, {});
    config.trace.sampling = {.sample = 2, .seed = 3};
    compare(scene, {});
}

TEST_P(EqualityOfPassesGl, FigureOneBySamples) {
    const FlatScene scene = flatten(*make_procedural("cornell"));
    for (const int sample : {0, 7, 15}) {
        config.trace.sampling = {.sample = sample, .seed = 1};
        compare(scene, {});
    }
}

TEST_P(EqualityOfPassesGl, SampledLight) {
    const FlatScene scene = test::soft_scene(200, 7);
    config.trace.sampling = {.sample = 3, .seed = 5};
    for (const int bounces : {0, 1, 3}) {
        SCOPED_TRACE(testing::Message() << bounces << " bounces");
        config.trace.reflection_depth = bounces;
        compare(scene, {});
    }
}

TEST_P(EqualityOfWalksGl, AxisAlignedCity) {
    // Split planes lie in the triangles, and the camera looks along an axis from inside a lattice plane.
    FlatScene scene = test::scene_of(test::voxel_city(4));
    scene.camera = {Vec3(2, 2, 12), Vec3(2, 2, 0), Vec3(0, 1, 0), 40.0f};
    compare(scene, {});
}

/// What only some traversals can choose.
TEST_P(EqualityOfPassesGl, ChoicesOfTheWalks) {
    FlatScene scene = test::mirror_scene(300, 7);
    scene.camera.eye = scene.camera.eye * 0.4f + scene.camera.target * 0.6f;  // within the tree
    const std::vector<TraceConfig> choices{
        {.traversal = Traversal::short_stack, .short_stack = 1},
        {.traversal = Traversal::short_stack, .short_stack = max_short_stack},
        {.traversal = Traversal::ropes, .optimised_ropes = false},
        {.traversal = Traversal::ropes, .eye_leaf = true},
        {.traversal = Traversal::stack, .entry_tile = 8},
        {.traversal = Traversal::restart, .entry_tile = 24},
        {.traversal = Traversal::backtrack, .entry_tile = 8},
        {.traversal = Traversal::short_stack, .short_stack = 2, .entry_tile = 1},
    };
    NodeEncoding nodes = NodeEncoding::float4;
    for (const TraceConfig& choice : choices) {
        SCOPED_TRACE(testing::Message() << info(choice.traversal).name << ", " << choice.short_stack
                                        << " entries, tiles of " << choice.entry_tile);
        EXPECT_NE(primary_visits(scene, choice), primary_visits(scene, {.traversal = choice.traversal}))
            << "a choice that changes nothing";
        config.trace = choice;
        config.trace.leaf_lists = GetParam().lists;
        compare(scene, {}, nodes);
        nodes = nodes == NodeEncoding::float4 ? NodeEncoding::packed : NodeEncoding::float4;
    }
}

TEST_P(EqualityOfWalksGl, EmptyScene) {
    FlatScene scene = test::scene_of({});
    scene.camera = {};
    compare(scene, {});
}

}  // namespace
}  // namespace kd
