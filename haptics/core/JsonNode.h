// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate
{

/// The fault of a file, and its place.
struct JsonProblem : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// An object of a file that is not trusted, and where it is, for messages. `Json` is nlohmann::json: VTK has a copy of
/// that library under another name, and both read files so.
template<class Json>
class JsonNode
{
public:
  JsonNode(const Json& json, std::string at) : json_(json), at_(std::move(at))
  {
    if (!json.is_object())
    {
      this->fail("", "must be an object, { ... }");
    }
  }

  [[noreturn]] void fail(const std::string& key, const std::string& what) const
  {
    const std::string place = this->at_ + (key.empty() || this->at_.empty() ? "" : ".") + key;
    throw JsonProblem(place + (place.empty() ? "" : ": ") + what);
  }

  /// A refusal of a key fails here; "": none.
  void accept(const std::string& key, const std::string& refusal) const
  {
    if (!refusal.empty())
    {
      this->fail(key, refusal);
    }
  }

  void knows(const std::vector<const char*>& keys) const
  {
    for (const auto& [key, value] : this->json_.items())
    {
      const bool known = std::any_of(keys.begin(), keys.end(), [&k = key](const char* name) { return k == name; });
      if (!known)
      {
        std::string all;
        for (const char* name : keys)
        {
          all += (all.empty() ? "" : ", ") + std::string(name);
        }
        this->fail(key, "unknown key; valid keys: " + all);
      }
    }
  }

  [[nodiscard]] bool has(const char* key) const { return this->json_.contains(key); }

  [[nodiscard]] double number(const char* key, double usual) const
  {
    return this->has(key) ? this->toNumber(key, this->json_[key]) : usual;
  }

  [[nodiscard]] double needsNumber(const char* key) const
  {
    if (!this->has(key))
    {
      this->fail(key, "this key is missing");
    }
    return this->number(key, 0.0);
  }

  /// A whole number of that range.
  [[nodiscard]] int whole(const char* key, int usual, int low, int high) const
  {
    const double number = this->number(key, usual);
    if (!(number >= low && number <= high && number == std::floor(number)))
    {
      this->fail(key, "must be a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    }
    return static_cast<int>(number);
  }

  [[nodiscard]] bool flag(const char* key, bool usual) const
  {
    if (this->has(key) && !this->json_[key].is_boolean())
    {
      this->fail(key, "must be true or false");
    }
    return this->has(key) ? this->json_[key].template get<bool>() : usual;
  }

  /// A number from 0 on, 0 where this key is missing.
  [[nodiscard]] double size(const char* key) const
  {
    const double size = this->number(key, 0.0);
    if (size < 0.0)
    {
      this->fail(key, "must not be below 0");
    }
    return size;
  }

  [[nodiscard]] std::string text(const char* key, const std::string& usual) const
  {
    if (!this->has(key))
    {
      return usual;
    }
    if (!this->json_[key].is_string())
    {
      this->fail(key, "must be a text in quotes");
    }
    return this->json_[key].template get<std::string>();
  }

  [[nodiscard]] std::string needed(const char* key) const
  {
    const std::string text = this->text(key, "");
    if (text.empty())
    {
      this->fail(key, "this key is missing");
    }
    return text;
  }

  /// Names that tables have as headings.
  [[nodiscard]] std::string name() const
  {
    const std::string name = this->needed("name");
    if (std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == ',' || c == '"'; }))
    {
      this->fail("name", "a name must not contain commas, quotes or line breaks");
    }
    return name;
  }

  [[nodiscard]] Vec3 vector(const char* key, const Vec3& usual) const
  {
    if (!this->has(key))
    {
      return usual;
    }
    const std::vector<double> numbers = this->numbers(key, 3);
    return { numbers[0], numbers[1], numbers[2] };
  }

  [[nodiscard]] Quat turn(const char* key) const
  {
    if (!this->has(key))
    {
      return Quat::Identity();
    }
    const std::vector<double> n = this->numbers(key, 4);
    const Quat q(n[0], n[1], n[2], n[3]);
    if (!(std::abs(q.norm() - 1.0) < 1e-6))
    {
      this->fail(key, "a rotation must be a quaternion [w, x, y, z] of length 1");
    }
    return q.normalized();
  }

  /// An object within this one.
  [[nodiscard]] JsonNode part(const char* key) const
  {
    if (!this->has(key))
    {
      this->fail(key, "this key is missing");
    }
    return { this->json_[key], (this->at_.empty() ? "" : this->at_ + ".") + key };
  }

  /// The objects of a list.
  [[nodiscard]] std::vector<JsonNode> list(const char* key) const
  {
    if (!this->has(key) || !this->json_[key].is_array())
    {
      this->fail(key, "must be a list, [ ... ]");
    }
    std::vector<JsonNode> nodes;
    for (const Json& value : this->json_[key])
    {
      nodes.emplace_back(value, std::string(key) + "[" + std::to_string(nodes.size()) + "]");
    }
    return nodes;
  }

  [[nodiscard]] std::vector<double> numbers(const char* key, std::size_t count) const
  {
    const Json list = this->has(key) ? this->json_[key] : Json();
    if (!list.is_array() || list.size() != count)
    {
      this->fail(key, "must be a list of " + std::to_string(count) + " numbers");
    }
    std::vector<double> numbers;
    std::transform(list.begin(), list.end(), std::back_inserter(numbers),
      [&](const Json& value) { return this->toNumber(key, value); });
    return numbers;
  }

  /// The texts of a list.
  [[nodiscard]] std::vector<std::string> texts(const char* key) const
  {
    const Json list = this->has(key) ? this->json_[key] : Json();
    const bool areTexts =
      list.is_array() && std::all_of(list.begin(), list.end(), [](const Json& value) { return value.is_string(); });
    if (!areTexts)
    {
      this->fail(key, "must be a list of texts in quotes");
    }
    return list.template get<std::vector<std::string>>();
  }

  /// So many times true or false, false where this key is missing.
  [[nodiscard]] std::vector<bool> flags(const char* key, std::size_t count) const
  {
    if (!this->has(key))
    {
      return std::vector<bool>(count, false);
    }
    const Json& list = this->json_[key];
    const bool areFlags = list.is_array() && list.size() == count &&
                          std::all_of(list.begin(), list.end(), [](const Json& value) { return value.is_boolean(); });
    if (!areFlags)
    {
      this->fail(key, "must be a list of " + std::to_string(count) + " times true or false");
    }
    return list.template get<std::vector<bool>>();
  }

private:
  [[nodiscard]] double toNumber(const char* key, const Json& value) const
  {
    if (!value.is_number() || !std::isfinite(value.template get<double>()))
    {
      this->fail(key, "must be a finite number");
    }
    return value.template get<double>();
  }

  const Json& json_;
  std::string at_;
};

/// Fails unless the file says that it has this format, and a version that this program reads.
template<class Json>
void checkHead(const JsonNode<Json>& root, const char* format, int newest)
{
  if (root.needed("format") != format)
  {
    root.fail("format", std::string("must be \"") + format + "\"");
  }
  const double version = root.number("version", 0.0);
  if (version != newest)
  {
    root.fail("version", "this program reads version " + std::to_string(newest) +
                           (version > newest ? "; the file has a later version: update Palpate" : ""));
  }
}

/// The fault that the reading of such a text found, or "".
template<class Json, class Read>
[[nodiscard]] std::string jsonProblemOf(const Read& read)
{
  try
  {
    read();
    return "";
  }
  catch (const typename Json::parse_error& error)
  {
    return "not JSON: byte " + std::to_string(error.byte) + " is unexpected";
  }
  catch (const typename Json::exception&)
  {
    return "the JSON text has a number that is too large";
  }
  catch (const JsonProblem& problem)
  {
    return problem.what();
  }
}

} // namespace palpate
