// Reads the fields of a session from JSON, and refuses what is none: the visitor of app/session_fields.h that takes.
#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include "app/report/json_values.h"
#include "app/session_fields.h"

namespace kd {

/// Of one JSON object at `place`, such as "F.session.json: /settings". A missing key leaves its field as it was.
/// Everything throws InputError with the place, what stands there and what would be right.
class FieldReader {
  public:
    FieldReader(const Json& json, std::string place);

    void text(const char* key, std::string& value);
    void flag(const char* key, bool& value);
    void opposite(const char* key, bool& value);
    void point(const char* key, Vec3& value);
    template <class T>
    void number(const char* key, T& value, const Limits<T>& limits) {
        if (const Json* found = find(key)) value = number_in(*found, key, limits);
    }
    template <class T>
    void choice(const char* key, T& value, const std::vector<NamedValue<T>>& choices) {
        if (const Json* found = find(key)) value = choice_in(*found, key, choices);
    }
    void node_bytes(const char* key, NodeEncoding& value);
    /// Also the text in quotes that files had before.
    void packet_rays(const char* key, int& value);
    void set(const char* key, FeatureSet& value, const std::vector<NamedValue<Feature>>& choices);
    void value_range(const char* key, HeatmapConfig& heat);
    void camera(const char* key, std::optional<Camera>& value);
    void hand_splits(const char* key, std::vector<HandSplit>& value);
    template <class Visit>
    void object(const char* key, const Visit& visit) {
        const Json* found = find(key);
        if (!found) return;
        FieldReader inner(*found, place_of(key));
        visit(inner);
        inner.refuse_others();
    }

    /// Keys that nobody asked for.
    void refuse_others() const;
    [[noreturn]] void refuse(const std::string& key, const std::string& why) const;

  private:
    /// Null where the key is missing.
    const Json* find(const char* key);
    [[nodiscard]] std::string place_of(const std::string& key) const;
    [[noreturn]] void refuse_value(const Json& found, const std::string& key, const std::string& wanted) const;
    [[nodiscard]] bool bool_in(const Json& found, const std::string& key) const;
    [[nodiscard]] std::string text_in(const Json& found, const std::string& key) const;
    /// The first `count` of an array of so many numbers.
    [[nodiscard]] std::vector<float> floats_in(const Json& found, const std::string& key, std::size_t count,
                                               const char* wanted) const;

    template <class T>
    [[nodiscard]] T number_in(const Json& found, const std::string& key, const Limits<T>& limits) const {
        // Compared as double first: not every number of a file fits into a T.
        const bool kind = std::is_integral_v<T> ? found.is_number_integer() : found.is_number();
        const double value = kind ? found.get<double>() : 0;
        using Widest = std::numeric_limits<T>;
        const bool fits = kind && value >= double(Widest::lowest()) && value <= double(Widest::max());
        if (!fits || !limits.hold(T(value))) refuse_value(found, key, limits.text());
        return T(value);
    }

    template <class T>
    [[nodiscard]] T choice_in(const Json& found, const std::string& key,
                              const std::vector<NamedValue<T>>& choices) const {
        try {
            return chosen(choices, text_in(found, key), "name");
        } catch (const std::invalid_argument& error) {
            refuse(key, error.what());
        }
    }

    const Json& json_;
    std::string place_;
    std::vector<std::string> known_;
};

}  // namespace kd
