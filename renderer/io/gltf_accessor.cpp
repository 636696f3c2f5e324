#include "renderer/io/gltf_accessor.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace kd {

namespace {

/// Calls `use` with a zero of the C++ type of a glTF component type; false where there is none.
template <class Use>
bool with_component_type(int type, Use use) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE: use(std::int8_t{}); return true;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: use(std::uint8_t{}); return true;
        case TINYGLTF_COMPONENT_TYPE_SHORT: use(std::int16_t{}); return true;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: use(std::uint16_t{}); return true;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: use(std::uint32_t{}); return true;
        case TINYGLTF_COMPONENT_TYPE_FLOAT: use(float{}); return true;
        default: return false;
    }
}

/// Bytes of a component; 0 for a type that glTF does not have.
std::uint64_t component_size(int type) {
    std::uint64_t size = 0;
    with_component_type(type, [&](auto zero) { size = sizeof(zero); });
    return size;
}

/// Columns of a matrix; vectors and scalars have one.
std::uint64_t column_count(int type) {
    switch (type) {
        case TINYGLTF_TYPE_MAT2: return 2;
        case TINYGLTF_TYPE_MAT3: return 3;
        case TINYGLTF_TYPE_MAT4: return 4;
        default: return 1;
    }
}

/// Bytes of an element. Columns of matrices begin at multiples of 4.
std::uint64_t element_size(const tinygltf::Accessor& accessor) {
    const std::uint64_t columns = column_count(accessor.type);
    const std::uint64_t column = component_count(accessor) / columns * component_size(accessor.componentType);
    return columns == 1 ? column : columns * ((column + 3) / 4 * 4);
}

struct Range {
    std::size_t view;
    std::uint64_t offset, count, element, stride, alignment;
};

/// `count` elements, `stride` apart from `offset` on, lie within the view. All in 64 bits, by subtraction and division,
/// so that no value in a file can make it wrap.
void check_range(const GltfContext& context, const tinygltf::Model& model, const Range& range,
                 const std::string& pointer) {
    const tinygltf::BufferView& view = model.bufferViews[range.view];
    const std::string place = pointer_to(pointer, "byteOffset");
    const std::uint64_t length = view.byteLength;
    if (range.stride < range.element) {
        context.fail(pointer_to(pointer_to("/bufferViews", range.view), "byteStride"),
                     std::to_string(range.stride) + " is less than the " + std::to_string(range.element) +
                         " bytes of an element of " + pointer);
    }
    if (range.offset > length || range.element > length - range.offset ||
        range.count - 1 > (length - range.offset - range.element) / range.stride) {
        context.fail(place, std::to_string(range.count) + " elements, " + std::to_string(range.stride) +
                                " bytes apart from " + std::to_string(range.offset) +
                                " on, reach beyond the bufferView's " + std::to_string(length) + " bytes");
    }
    if ((view.byteOffset + range.offset) % range.alignment != 0) {
        context.fail(place, "the data must begin at a multiple of " + std::to_string(range.alignment) + " bytes");
    }
}

void check_sparse(const GltfContext& context, const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                  const std::string& accessor_pointer) {
    const auto& sparse = accessor.sparse;
    const std::string pointer = pointer_to(accessor_pointer, "sparse");
    const auto count = static_cast<std::uint64_t>(sparse.count);
    if (count == 0 || count > accessor.count) {
        context.fail(pointer_to(pointer, "count"),
                     "must be from 1 to the accessor's " + std::to_string(accessor.count));
    }
    const int type = sparse.indices.componentType;
    if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
        type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
        context.fail(pointer_to(pointer, "indices") + "/componentType", "must be 5121, 5123 or 5125");
    }
    const std::uint64_t index = component_size(type);
    check_range(context, model,
                {static_cast<std::size_t>(sparse.indices.bufferView),
                 static_cast<std::uint64_t>(sparse.indices.byteOffset), count, index, index, index},
                pointer_to(pointer, "indices"));
    const std::uint64_t element = element_size(accessor);
    check_range(context, model,
                {static_cast<std::size_t>(sparse.values.bufferView),
                 static_cast<std::uint64_t>(sparse.values.byteOffset), count, element, element,
                 component_size(accessor.componentType)},
                pointer_to(pointer, "values"));
}

void check_accessor(const GltfContext& context, const tinygltf::Model& model, std::size_t index) {
    const tinygltf::Accessor& accessor = model.accessors[index];
    const std::string pointer = pointer_to("/accessors", index);
    if (component_size(accessor.componentType) == 0) {
        context.fail(pointer_to(pointer, "componentType"),
                     std::to_string(accessor.componentType) + " is none of 5120, 5121, 5122, 5123, 5125, 5126");
    }
    if (accessor.count == 0) context.fail(pointer_to(pointer, "count"), "must be 1 or more");
    if (accessor.bufferView >= 0) {
        const auto view = static_cast<std::size_t>(accessor.bufferView);
        const std::uint64_t element = element_size(accessor);
        const std::uint64_t stride = model.bufferViews[view].byteStride;
        check_range(context, model,
                    {view, accessor.byteOffset, accessor.count, element, stride == 0 ? element : stride,
                     component_size(accessor.componentType)},
                    pointer);
    }
    if (accessor.sparse.isSparse) check_sparse(context, model, accessor, pointer);
}

const unsigned char* bytes_of(const tinygltf::Model& model, int view, std::uint64_t offset) {
    const tinygltf::BufferView& v = model.bufferViews[static_cast<std::size_t>(view)];
    return model.buffers[static_cast<std::size_t>(v.buffer)].data.data() + v.byteOffset + offset;
}

template <class Stored>
Stored load(const unsigned char* bytes) {
    Stored value;
    std::memcpy(&value, bytes, sizeof(value));  // alignment is that of the file
    return value;
}

/// glTF 2.0, section 3.6.2.2: signed values are symmetric, and the most negative one is clamped.
template <class Stored>
float as_float(Stored value, bool normalized) {
    const auto plain = static_cast<float>(value);
    if (std::is_floating_point_v<Stored> || !normalized) return plain;
    return std::max(plain / static_cast<float>(std::numeric_limits<Stored>::max()), -1.0f);
}

/// Reads all elements with `convert` from the stored type to Out. Matrices are not asked for, so components are
/// adjacent.
template <class Out, class Stored, class Convert>
std::vector<Out> gather(const GltfContext& context, const tinygltf::Model& model, int index, Convert convert) {
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    const std::size_t components = component_count(accessor);
    const std::uint64_t element = element_size(accessor);
    std::vector<Out> out(accessor.count * components);
    const auto copy = [&](const unsigned char* from, std::size_t to) {
        for (std::size_t i = 0; i < components; ++i) {
            out[to * components + i] = convert(load<Stored>(from + i * sizeof(Stored)));
        }
    };

    if (accessor.bufferView >= 0) {
        const unsigned char* from = bytes_of(model, accessor.bufferView, accessor.byteOffset);
        const std::size_t given = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
        const std::size_t stride = given == 0 ? element : given;
        for (std::size_t i = 0; i < accessor.count; ++i) copy(from + i * stride, i);
    }
    if (!accessor.sparse.isSparse) return out;

    const auto& sparse = accessor.sparse;
    const unsigned char* indices =
        bytes_of(model, sparse.indices.bufferView, static_cast<std::uint64_t>(sparse.indices.byteOffset));
    const unsigned char* values =
        bytes_of(model, sparse.values.bufferView, static_cast<std::uint64_t>(sparse.values.byteOffset));
    for (std::size_t i = 0; i < static_cast<std::size_t>(sparse.count); ++i) {
        std::size_t target = 0;
        with_component_type(sparse.indices.componentType, [&](auto zero) {
            target = static_cast<std::size_t>(load<decltype(zero)>(indices + i * sizeof(zero)));
        });
        if (target >= accessor.count) {
            context.fail(pointer_to("/accessors", static_cast<std::size_t>(index)) + "/sparse/indices",
                         "index " + std::to_string(target) + " is outside of the accessor's " +
                             std::to_string(accessor.count) + " elements");
        }
        copy(values + i * element, target);
    }
    return out;
}

}  // namespace

std::size_t component_count(const tinygltf::Accessor& accessor) {
    switch (accessor.type) {
        case TINYGLTF_TYPE_VEC2: return 2;
        case TINYGLTF_TYPE_VEC3: return 3;
        case TINYGLTF_TYPE_VEC4:
        case TINYGLTF_TYPE_MAT2: return 4;
        case TINYGLTF_TYPE_MAT3: return 9;
        case TINYGLTF_TYPE_MAT4: return 16;
        default: return 1;
    }
}

void check_accessors(const GltfContext& context, const tinygltf::Model& model) {
    for (std::size_t i = 0; i < model.accessors.size(); ++i) check_accessor(context, model, i);
}

std::vector<float> read_floats(const GltfContext& context, const tinygltf::Model& model, int accessor) {
    const tinygltf::Accessor& a = model.accessors[static_cast<std::size_t>(accessor)];
    std::vector<float> values;
    with_component_type(a.componentType, [&](auto zero) {
        using Stored = decltype(zero);
        values = gather<float, Stored>(context, model, accessor,
                                       [&](Stored value) { return as_float(value, a.normalized); });
    });
    return values;
}

std::vector<std::uint32_t> read_indices(const GltfContext& context, const tinygltf::Model& model, int accessor) {
    const tinygltf::Accessor& a = model.accessors[static_cast<std::size_t>(accessor)];
    std::vector<std::uint32_t> indices;
    if (a.type == TINYGLTF_TYPE_SCALAR) {
        with_component_type(a.componentType, [&](auto zero) {
            using Stored = decltype(zero);
            if constexpr (std::is_unsigned_v<Stored>) {
                indices = gather<std::uint32_t, Stored>(context, model, accessor,
                                                        [](Stored value) { return std::uint32_t(value); });
            }
        });
    }
    if (indices.empty()) {
        context.fail(pointer_to("/accessors", static_cast<std::size_t>(accessor)),
                     "indices must be SCALAR of component type 5121, 5123 or 5125");
    }
    return indices;
}

}  // namespace kd
