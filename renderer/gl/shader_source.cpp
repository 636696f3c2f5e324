#include "renderer/gl/shader_source.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <regex>

#include "renderer/gl/shader_text.h"

namespace kd {

namespace {

constexpr const char* version_line = "#version 430 core";

/// The name in `#include "name"`, nothing for other lines.
std::optional<std::string> included_name(const std::string& line) {
    static const std::regex pattern(R"re(^\s*#\s*include\s+"([^"]+)"\s*(//.*)?$)re");
    std::smatch match;
    if (!std::regex_match(line, match, pattern)) return std::nullopt;
    return match[1];
}

class Resolver {
  public:
    Resolver(const ShaderReader& read, ShaderSource& result) : read_(read), result_(result) {}

    void add_line(const std::string& line, ShaderSource::Origin origin) {
        result_.text += line;
        result_.text += '\n';
        result_.lines.push_back(origin);
    }

    /// Appends the file at `path`; `from` says who asked for it.
    void add_file(const std::string& path, const std::string& text) {
        open_.push_back(path);
        const std::size_t file = result_.files.size();
        result_.files.push_back("shaders/" + path);

        std::size_t begin = 0;
        for (int number = 1; begin < text.size(); ++number) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            std::string line = text.substr(begin, end - begin);
            if (line.ends_with('\r')) line.pop_back();
            begin = end + 1;
            if (const auto name = included_name(line)) {
                include(*name, {file, number});
            } else {
                add_line(line, {file, number});
            }
        }
        open_.pop_back();
    }

  private:
    const ShaderReader& read_;
    ShaderSource& result_;
    std::vector<std::string> open_;  // files being read, outermost first

    void include(const std::string& name, ShaderSource::Origin from) {
        const std::string place = fmt::format("{}:{}", result_.files[from.file], from.line);
        const std::string beside = (std::filesystem::path(open_.back()).parent_path() / name).lexically_normal();
        for (const std::string& path : {beside, name}) {
            if (std::ranges::find(open_, path) != open_.end())
                throw ShaderError(fmt::format("{}: \"{}\" includes itself", place, name));
            if (const auto text = read_(path)) return add_file(path, *text);
        }
        throw ShaderError(fmt::format("{}: there is no \"{}\", neither beside this file nor in shaders/", place, name));
    }
};

std::optional<std::string> embedded_file(const std::string& path) {
    const auto files = shader_files();
    const auto found = std::ranges::find(files, path, &ShaderFile::path);
    if (found == files.end()) return std::nullopt;
    return std::string(found->text);
}

std::optional<std::string> file_on_disk(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in || std::filesystem::is_directory(path)) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(in), {});
}

}  // namespace

ShaderReader default_shader_reader() {
    const char* folder = std::getenv("KD_SHADER_DIR");
    if (!folder || !*folder) return embedded_file;
    return [root = std::filesystem::path(folder)](const std::string& path) { return file_on_disk(root / path); };
}

std::string ShaderSource::locate(int line) const {
    if (line < 1 || std::size_t(line) > lines.size()) return fmt::format("{}:{}", files.front(), line);
    const Origin& origin = lines[std::size_t(line) - 1];
    return fmt::format("{}:{}", files[origin.file], origin.line);
}

std::string ShaderSource::map_log(std::string_view log) const {
    // String 0, then the line: "0:12(7)", "0(12)" or "0:12".
    static const std::regex position(R"((^|[^\w.])0(?::(\d+)\(\d+\)|\((\d+)\)|:(\d+)(?!\d)))");
    const std::string all(log);
    std::string mapped;
    auto rest = all.cbegin();
    for (std::sregex_iterator match(all.begin(), all.end(), position), end; match != end; ++match) {
        int line = 0;
        for (const std::size_t group : {2u, 3u, 4u})
            if ((*match)[group].matched) line = std::atoi((*match)[group].str().c_str());
        mapped.append(rest, (*match)[0].first);
        mapped += (*match)[1].str() + locate(line);
        rest = (*match)[0].second;
    }
    mapped.append(rest, all.cend());
    return mapped;
}

ShaderSource resolve_shader(const std::string& entry, const ShaderDefines& defines, const ShaderReader& read) {
    ShaderSource result;
    result.files.push_back("settings of " + entry);
    Resolver resolver(read, result);
    int number = 0;
    resolver.add_line(version_line, {0, ++number});
    for (const auto& [name, value] : defines)
        resolver.add_line(fmt::format("#define {} {}", name, value), {0, ++number});

    const auto text = read(entry);
    if (!text) throw ShaderError(fmt::format("there is no shader file \"{}\" in shaders/", entry));
    resolver.add_file(entry, *text);
    return result;
}

}  // namespace kd
