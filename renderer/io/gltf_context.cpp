#include "renderer/io/gltf_context.h"

#include <algorithm>

#include "renderer/geometry/input_error.h"
#include "renderer/io/printable.h"

namespace kd {

GltfContext::GltfContext(std::string file, const GltfLimits& limits) : file_(printable(file, 4096)), limits_(limits) {}

void GltfContext::fail(std::string_view pointer, std::string_view reason) const {
    std::string line = file_ + ": ";
    if (!pointer.empty()) line += std::string(pointer) + ": ";
    throw InputError(line + printable(reason, 400));
}

void GltfContext::note(std::string_view text) {
    const Entry entry{printable(text, 400), "", 0};
    if (std::ranges::find(entries_, entry) != entries_.end()) return;
    if (entries_.size() < limits_.notes)
        entries_.push_back(entry);
    else
        ++untold_;
}

void GltfContext::count(std::string_view verb, std::string_view noun, std::string_view what, std::uint64_t number) {
    if (number == 0) return;
    const std::string before = std::string(verb) + "\n" + std::string(noun);  // the line feed holds the number's place
    const std::string after = printable(what, 400);
    for (Entry& entry : entries_) {
        if (entry.number > 0 && entry.before == before && entry.after == after) {
            entry.number += number;
            return;
        }
    }
    entries_.push_back({before, after, number});
}

std::vector<std::string> GltfContext::notes() const {
    std::vector<std::string> lines;
    for (const Entry& entry : entries_) {
        std::string line = entry.before;
        if (entry.number > 0) {
            line.replace(line.find('\n'), 1, " " + std::to_string(entry.number) + " ");
            line += (entry.number == 1 ? "" : "s") + entry.after;
        }
        lines.push_back(std::move(line));
    }
    if (untold_ > 0) lines.push_back("and " + std::to_string(untold_) + " more of such remarks");
    return lines;
}

std::string pointer_to(std::string_view parent, std::size_t index) {
    return std::string(parent) + "/" + std::to_string(index);
}

std::string pointer_to(std::string_view parent, std::string_view key) {
    std::string escaped;
    for (const char c : printable(key, 60)) {
        if (c == '~')
            escaped += "~0";
        else if (c == '/')
            escaped += "~1";
        else
            escaped += c;
    }
    return std::string(parent) + "/" + escaped;
}

}  // namespace kd
