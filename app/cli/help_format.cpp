#include "app/cli/help_format.h"

namespace kd {

namespace {

constexpr std::size_t text_column = 33;
constexpr std::size_t last_column = 100;

/// `name` at the left, `text` from the text column on, in as many lines as it needs.
std::string entry_lines(const std::string& name, const std::string& text) {
    std::string lines = "  " + name;
    std::size_t column = lines.size();
    const auto new_line = [&] {
        lines += "\n" + std::string(text_column, ' ');
        column = text_column;
    };
    if (column + 2 > text_column)
        new_line();
    else {
        lines += std::string(text_column - column, ' ');
        column = text_column;
    }
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::size_t length = end - at;
        if (column > text_column && column + 1 + length > last_column)
            new_line();
        else if (column > text_column) {
            lines += ' ';
            ++column;
        }
        lines += text.substr(at, length);
        column += length;
        at = end + 1;
    }
    return lines + "\n";
}

}  // namespace

std::string help_list(std::string_view title, const std::vector<HelpEntry>& entries) {
    std::string list = std::string(title) + ":\n";
    for (const HelpEntry& entry : entries) list += entry_lines(entry.name, entry.text);
    return list;
}

HelpFormatter::HelpFormatter() {
    label("OPTIONS", "options");
    label("SUBCOMMAND", "COMMAND");
    label("Positionals", "Scene");
    label("REQUIRED", "(required)");
}

std::string HelpFormatter::make_group(std::string group, bool is_positional,
                                      std::vector<const CLI::Option*> options) const {
    // CLI11 itself separates the groups after the first.
    std::string text = (is_positional || group == "Options" ? "\n" : "") + group + ":\n";
    for (const CLI::Option* option : options) text += make_option(option, is_positional);
    return text;
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool is_positional) const {
    return entry_lines(make_option_name(option, is_positional) + make_option_opts(option), make_option_desc(option));
}

std::string HelpFormatter::make_subcommand(const CLI::App* sub) const {
    return entry_lines(sub->get_name(), sub->get_description());
}

}  // namespace kd
