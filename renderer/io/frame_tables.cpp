// A frame as a table of numbers: CSV and EXR.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <iterator>
#include <memory>
#include <tinyexr.h>

#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/printable.h"
#include "renderer/io/tables.h"
#include "renderer/trace/counters.h"

namespace kd {

namespace {

bool ran(const Frame& frame, Pass pass) {
    if (pass == Pass::rt_prim) return true;
    const RayLayer& layer = frame.layer(pass);
    return std::ranges::any_of(layer.hit.pixels, [](const Hit& hit) { return hit.triangle >= 0; }) ||
           std::ranges::any_of(layer.counters.pixels, [](const RayCounters& c) { return !(c == RayCounters{}); });
}

std::vector<Pass> passes_run(const Frame& frame) {
    std::vector<Pass> passes;
    for (int i = 0; i < pass_count; ++i) {
        if (ran(frame, static_cast<Pass>(i))) passes.push_back(static_cast<Pass>(i));
    }
    return passes;
}

std::string csv_header(const std::vector<Pass>& passes) {
    std::string header = "x,y";
    for (const Pass pass : passes) {
        std::string rays(ray_names[static_cast<std::size_t>(pass)]);
        std::ranges::replace(rays, ' ', '_');
        for (const char* value : {"triangle", "t", "u", "v"}) header += "," + rays + "_" + value;
        for (const CounterInfo& counter : counter_table()) header += "," + rays + "_" + std::string(counter.name);
        header += "," + rays + "_exit_reason";
    }
    return header + "\n";
}

/// The free() that belongs to memory from tinyexr.
struct Free {
    void operator()(void* memory) const { std::free(memory); }
};

struct Channel {
    std::string name;
    std::vector<float> values;
};

/// Sorted by name, as the format demands.
std::vector<Channel> channels_of(const Frame& frame, const RayLayer& layer) {
    std::vector<Channel> channels;
    const auto add = [&](std::string_view name, const auto& pixels, auto value) {
        Channel channel{std::string(name), {}};
        channel.values.reserve(pixels.size());
        for (const auto& pixel : pixels) channel.values.push_back(static_cast<float>(value(pixel)));
        channels.push_back(std::move(channel));
    };
    for (const CounterInfo& counter : counter_table()) {
        add(counter.name, layer.counters.pixels, [&](const RayCounters& c) { return c.*counter.field; });
    }
    add("exit_reason", layer.counters.pixels, [](const RayCounters& c) { return c.exit_reason; });
    add("t", layer.hit.pixels, [&](const Hit& hit) { return in_scene_units(frame, hit).t; });
    std::ranges::sort(channels, {}, &Channel::name);
    return channels;
}

std::string encode_exr(std::vector<Channel>& channels, int width, int height, const std::string& name) {
    std::vector<EXRChannelInfo> infos(channels.size());
    std::vector<int> types(channels.size(), TINYEXR_PIXELTYPE_FLOAT);
    std::vector<unsigned char*> planes;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        infos[i] = {};
        std::strncpy(infos[i].name, channels[i].name.c_str(), sizeof(infos[i].name) - 1);
        planes.push_back(reinterpret_cast<unsigned char*>(channels[i].values.data()));
    }
    // Both structures only borrow; nothing of theirs is freed by tinyexr.
    EXRHeader header;
    InitEXRHeader(&header);
    header.num_channels = static_cast<int>(channels.size());
    header.channels = infos.data();
    header.pixel_types = types.data();
    header.requested_pixel_types = types.data();
    header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
    EXRImage image;
    InitEXRImage(&image);
    image.num_channels = header.num_channels;
    image.images = planes.data();
    image.width = width;
    image.height = height;

    unsigned char* memory = nullptr;
    const char* message = nullptr;
    const std::size_t size = SaveEXRImageToMemory(&image, &header, &memory, &message);
    const std::unique_ptr<unsigned char, Free> owner(memory);
    if (size == 0) {
        const std::string reason = message != nullptr ? message : "the encoder failed";
        FreeEXRErrorMessage(message);
        throw InputError("cannot write " + printable(name, 4096) + ": " + printable(reason));
    }
    return std::string(reinterpret_cast<const char*>(memory), size);
}

}  // namespace

std::string frame_csv(const Frame& frame, const std::function<void(float)>& progress) {
    const std::vector<Pass> passes = passes_run(frame);
    std::string text = csv_header(passes);
    auto out = std::back_inserter(text);
    for (int y = 0; y < frame.height; ++y) {
        if (progress) progress(float(y) / float(frame.height));
        for (int x = 0; x < frame.width; ++x) {
            fmt::format_to(out, "{},{}", x, y);
            for (const Pass pass : passes) {
                const Hit hit = in_scene_units(frame, frame.layer(pass).hit.at(x, y));
                const RayCounters& counters = frame.layer(pass).counters.at(x, y);
                fmt::format_to(out, ",{},{},{},{}", hit.triangle, plain_zero(hit.t), plain_zero(hit.u),
                               plain_zero(hit.v));
                for (const CounterInfo& counter : counter_table()) fmt::format_to(out, ",{}", counters.*counter.field);
                const bool traced = ray_traced(frame, pass, frame.colour.index(x, y));
                fmt::format_to(out, ",{}", traced ? exit_reason_name(counters.exit_reason) : "none");
            }
            text += '\n';
        }
    }
    return text;
}

void write_frame_exr(const std::filesystem::path& path, const Frame& frame) {
    if (frame.width <= 0 || frame.height <= 0) {
        throw InputError("cannot write " + printable(path.string(), 4096) + ": the picture is empty");
    }
    std::vector<Channel> channels = channels_of(frame, frame.layer(Pass::rt_prim));
    write_file(path, encode_exr(channels, frame.width, frame.height, path.string()));
}

}  // namespace kd
