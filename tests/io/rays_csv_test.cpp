#include <bit>
#include <cmath>
#include <limits>
#include <locale>

#include "renderer/io/tables.h"
#include "tests/io/scratch.h"

#ifdef KD_WITH_RAPIDCHECK
#include <rapidcheck/gtest.h>
#endif

namespace kd {
namespace {

std::vector<Ray> read_text(const std::string& text) {
    const auto path = scratch_folder() / "rays.csv";
    put_bytes(path, text);
    return read_rays_csv(path);
}

std::string error_in(const std::string& text) {
    const std::string error = error_of([&] { (void)read_text(text); });
    const std::size_t name = error.find("rays.csv");
    return name == std::string::npos ? error : error.substr(name);
}

const std::string header = "ox,oy,oz,dx,dy,dz\n";

TEST(RaysCsv, DefaultsTheInterval) {
    const std::vector<Ray> rays = read_text(header + "1,2,3,0,0,-1\n");
    ASSERT_EQ(rays.size(), 1u);
    EXPECT_EQ(rays[0].origin, Vec3(1, 2, 3));
    EXPECT_EQ(rays[0].direction, Vec3(0, 0, -1));
    EXPECT_EQ(rays[0].t_min, 0.0f);
    EXPECT_EQ(rays[0].t_max, KD_T_LIMIT);
    EXPECT_EQ(rays[0].source, -1);
}

TEST(RaysCsv, TakesColumnsInAnyOrderAndSpreadsheetHabits) {
    const std::vector<Ray> rays =
        read_text("\xef\xbb\xbf tmax , dz,dy,dx,oz,oy,ox,tmin\r\n\r\n9, 6,5,4,3 ,2,1,0.5\r\n\n  \n8,6,5,4,3,2,1,0.25");
    ASSERT_EQ(rays.size(), 2u);
    EXPECT_EQ(rays[0].origin, Vec3(1, 2, 3));
    EXPECT_EQ(rays[0].direction, Vec3(4, 5, 6));
    EXPECT_EQ(rays[0].t_min, 0.5f);
    EXPECT_EQ(rays[0].t_max, 9.0f);
    EXPECT_EQ(rays[1].t_max, 8.0f);
}

TEST(RaysCsv, ReadsDecimalAndHexadecimalNumbers) {
    const std::vector<Ray> rays = read_text(header + "0x1.8p+1,-0X1p-149,+0x1.fffffep127,1.8p1,-1e-3,+2.5E2\n"
                                                     "1e-60,-1e-400,0x1p-200,1e-45,16777217,-0\n");
    ASSERT_EQ(rays.size(), 2u);
    EXPECT_EQ(rays[0].origin, Vec3(3.0f, -std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max()));
    EXPECT_EQ(rays[0].direction, Vec3(3.0f, -0.001f, 250.0f));
    EXPECT_EQ(rays[1].origin, Vec3(0, 0, 0)) << "what is too small for a float is zero";
    EXPECT_TRUE(std::signbit(rays[1].origin.y));
    EXPECT_EQ(rays[1].direction.x, std::numeric_limits<float>::denorm_min());
    EXPECT_EQ(rays[1].direction.y, 16777216.0f);
    EXPECT_TRUE(std::signbit(rays[1].direction.z));
}

TEST(RaysCsv, InfinityAndNanAreNumbersButAnIntervalEndsAtTheLimit) {
    const std::vector<Ray> rays = read_text("ox,oy,oz,dx,dy,dz,tmax\ninf,-inf,nan,0,0,1,inf\n0,0,0,0,0,1,3.4e38\n");
    ASSERT_EQ(rays.size(), 2u);
    EXPECT_EQ(rays[0].origin.x, std::numeric_limits<float>::infinity());
    EXPECT_EQ(rays[0].origin.y, -std::numeric_limits<float>::infinity());
    EXPECT_TRUE(std::isnan(rays[0].origin.z));
    EXPECT_EQ(rays[0].t_max, KD_T_LIMIT);
    EXPECT_EQ(rays[1].t_max, KD_T_LIMIT);
}

TEST(RaysCsv, HeaderAloneIsNoRay) { EXPECT_TRUE(read_text(header).empty()); }

TEST(RaysCsv, ErrorsNameLineAndColumn) {
    const std::string good = "0,0,0,0,0,1\n";
    EXPECT_EQ(error_in(header + good + "\n1,2,3,abc,5,6\n"), "rays.csv:4: column dx: 'abc' is not a number");
    EXPECT_EQ(error_in(header + "1,2,,4,5,6\n"), "rays.csv:2: column oz: '' is not a number");
    EXPECT_EQ(error_in(header + "1,2,3,4,5,6 7\n"), "rays.csv:2: column dz: '6 7' is not a number");
    EXPECT_EQ(error_in(header + "1,2,3,4,5,--6\n"), "rays.csv:2: column dz: '--6' is not a number");
    EXPECT_EQ(error_in(header + "1,2,3,4,5,0x\n"), "rays.csv:2: column dz: '0x' is not a number");
    EXPECT_EQ(error_in(header + "1,2,3,4,5,0x-1\n"), "rays.csv:2: column dz: '0x-1' is not a number");
    EXPECT_EQ(error_in(header + "1,2,3,4,5,1e39\n"), "rays.csv:2: column dz: 1e39 is beyond the largest float, 3.4e38");
    EXPECT_EQ(error_in(header + "-1e4000,2,3,4,5,6\n"),
              "rays.csv:2: column ox: -1e4000 is beyond the largest float, 3.4e38");
    EXPECT_EQ(error_in(header + "1,2,3,4,5\n"), "rays.csv:2: 5 values for 6 columns");
    EXPECT_EQ(error_in(header + "1,2,3,4,5,6,7\n"), "rays.csv:2: 7 values for 6 columns");
    EXPECT_TRUE(holds(error_in(header + "1,2,3,4,5,\x1b[31m\n"), "'?[31m' is not a number"));
}

TEST(RaysCsv, ErrorsInTheHeaderNameTheColumns) {
    EXPECT_TRUE(holds(error_in("ox,oy,oz,dx,dz\n"), "rays.csv:1: column dy is missing; the first line must be ox,oy,"));
    EXPECT_TRUE(holds(error_in("ox,oy,oz,dx,dy,dz,ox\n"), "rays.csv:1: column ox comes twice"));
    EXPECT_TRUE(holds(error_in("ox,oy,oz,dx,dy,dz,foo\n"), "rays.csv:1: unknown column 'foo'"));
    EXPECT_TRUE(holds(error_in("1,2,3,4,5,6\n"), "rays.csv:1: unknown column '1'"));
    EXPECT_TRUE(holds(error_in(""), "rays.csv: empty; the first line must be"));
    EXPECT_TRUE(holds(error_in("\n\n"), "rays.csv: empty"));
}

struct DecimalComma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(RaysCsv, DoesNotDependOnTheLocale) {
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
    const std::vector<Ray> rays = read_text(header + "1234.5,0,0,0,0,1\n");
    const std::string text = rays_csv(rays);
    const std::string table = frame_csv(Frame(1, 1));
    std::locale::global(before);
    EXPECT_EQ(rays.at(0).origin.x, 1234.5f);
    EXPECT_TRUE(holds(text, "0x1.34ap+10,0x0p+0"));
    EXPECT_TRUE(holds(table, "0,0,-1,0,0,0,"));
}

TEST(HexFloat, IsTheNotationOfC) {
    EXPECT_EQ(hex_float(1.5f), "0x1.8p+0");
    EXPECT_EQ(hex_float(-0.0f), "-0x0p+0");
    EXPECT_EQ(hex_float(std::numeric_limits<float>::infinity()), "inf");
    EXPECT_EQ(std::strtof(hex_float(0.1f).c_str(), nullptr), 0.1f);
    const float smallest = std::numeric_limits<float>::denorm_min();
    EXPECT_EQ(std::strtof(hex_float(-smallest).c_str(), nullptr), -smallest);
}

#ifdef KD_WITH_RAPIDCHECK
RC_GTEST_PROP(RaysCsv, RoundTripsBitForBit, ()) {
    const auto any_float = rc::gen::map(rc::gen::arbitrary<std::uint32_t>(), [](std::uint32_t bits) {
        const float value = std::bit_cast<float>(bits);
        return std::isnan(value) ? 0.0f : value;
    });
    const auto numbers = *rc::gen::container<std::vector<float>>(8, any_float);
    Ray ray{{numbers[0], numbers[1], numbers[2]},
            {numbers[3], numbers[4], numbers[5]},
            numbers[6],
            std::min(numbers[7], KD_T_LIMIT),
            -1};
    const std::vector<Ray> rays = read_text(rays_csv(std::vector<Ray>{ray}));
    RC_ASSERT(rays.size() == 1u);
    const auto bits = [](const Ray& r) {
        return std::vector<std::uint32_t>{
            std::bit_cast<std::uint32_t>(r.origin.x),    std::bit_cast<std::uint32_t>(r.origin.y),
            std::bit_cast<std::uint32_t>(r.origin.z),    std::bit_cast<std::uint32_t>(r.direction.x),
            std::bit_cast<std::uint32_t>(r.direction.y), std::bit_cast<std::uint32_t>(r.direction.z),
            std::bit_cast<std::uint32_t>(r.t_min),       std::bit_cast<std::uint32_t>(r.t_max)};
    };
    RC_ASSERT(bits(rays[0]) == bits(ray));
}
#endif

}  // namespace
}  // namespace kd
