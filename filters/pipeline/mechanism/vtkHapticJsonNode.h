// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticJsonNode_h
#define vtkHapticJsonNode_h

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "haptics/core/Types.h"
#include "vtkHapticJson.h"

/// The fault of a file, and its place.
struct vtkHapticJsonProblem : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// An object of the file and where it is, for messages.
class vtkHapticJsonNode
{
public:
  vtkHapticJsonNode(const nlohmann::json& json, std::string at) : Value(json), At(std::move(at))
  {
    if (!json.is_object())
    {
      this->Fail("", "must be an object, { ... }");
    }
  }

  [[noreturn]] void Fail(const std::string& key, const std::string& what) const
  {
    const std::string place = this->At + (key.empty() || this->At.empty() ? "" : ".") + key;
    throw vtkHapticJsonProblem(place + (place.empty() ? "" : ": ") + what);
  }

  /// A refusal of a key fails here; "": none.
  void Accept(const std::string& key, const std::string& refusal) const
  {
    if (!refusal.empty())
    {
      this->Fail(key, refusal);
    }
  }

  void Knows(std::initializer_list<const char*> keys) const
  {
    for (const auto& [key, value] : this->Value.items())
    {
      const bool known = std::any_of(keys.begin(), keys.end(), [&k = key](const char* name) { return k == name; });
      if (!known)
      {
        std::string all;
        for (const char* name : keys)
        {
          all += (all.empty() ? "" : ", ") + std::string(name);
        }
        this->Fail(key, "unknown key; valid keys: " + all);
      }
    }
  }

  [[nodiscard]] bool Has(const char* key) const { return this->Value.contains(key); }

  [[nodiscard]] double Number(const char* key, double usual) const
  {
    return this->Has(key) ? this->ToNumber(key, this->Value[key]) : usual;
  }

  /// A number from 0 on, 0 where this key is missing.
  [[nodiscard]] double Size(const char* key) const
  {
    const double size = this->Number(key, 0.0);
    if (size < 0.0)
    {
      this->Fail(key, "must not be below 0");
    }
    return size;
  }

  [[nodiscard]] std::string Text(const char* key, const std::string& usual) const
  {
    if (!this->Has(key))
    {
      return usual;
    }
    if (!this->Value[key].is_string())
    {
      this->Fail(key, "must be a text in quotes");
    }
    return this->Value[key].get<std::string>();
  }

  [[nodiscard]] std::string Needed(const char* key) const
  {
    const std::string text = this->Text(key, "");
    if (text.empty())
    {
      this->Fail(key, "this key is missing");
    }
    return text;
  }

  /// Names that tables have as headings.
  [[nodiscard]] std::string Name() const
  {
    const std::string name = this->Needed("name");
    if (std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == ',' || c == '"'; }))
    {
      this->Fail("name", "a name must not contain commas, quotes or line breaks");
    }
    return name;
  }

  [[nodiscard]] palpate::Vec3 Vector(const char* key, const palpate::Vec3& usual) const
  {
    if (!this->Has(key))
    {
      return usual;
    }
    const std::vector<double> numbers = this->Numbers(key, 3);
    return { numbers[0], numbers[1], numbers[2] };
  }

  [[nodiscard]] palpate::Quat Turn(const char* key) const
  {
    if (!this->Has(key))
    {
      return palpate::Quat::Identity();
    }
    const std::vector<double> n = this->Numbers(key, 4);
    const palpate::Quat q(n[0], n[1], n[2], n[3]);
    if (!(std::abs(q.norm() - 1.0) < 1e-6))
    {
      this->Fail(key, "a rotation must be a quaternion [w, x, y, z] of length 1");
    }
    return q.normalized();
  }

  /// The objects of a list.
  [[nodiscard]] std::vector<vtkHapticJsonNode> List(const char* key) const
  {
    if (!this->Has(key) || !this->Value[key].is_array())
    {
      this->Fail(key, "must be a list, [ ... ]");
    }
    std::vector<vtkHapticJsonNode> nodes;
    for (const nlohmann::json& value : this->Value[key])
    {
      nodes.emplace_back(value, std::string(key) + "[" + std::to_string(nodes.size()) + "]");
    }
    return nodes;
  }

private:
  [[nodiscard]] double ToNumber(const char* key, const nlohmann::json& value) const
  {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
    {
      this->Fail(key, "must be a finite number");
    }
    return value.get<double>();
  }

  [[nodiscard]] std::vector<double> Numbers(const char* key, std::size_t count) const
  {
    const nlohmann::json& list = this->Value[key];
    if (!list.is_array() || list.size() != count)
    {
      this->Fail(key, "must be a list of " + std::to_string(count) + " numbers");
    }
    std::vector<double> numbers;
    std::transform(list.begin(), list.end(), std::back_inserter(numbers),
      [&](const nlohmann::json& value) { return this->ToNumber(key, value); });
    return numbers;
  }

  const nlohmann::json& Value;
  std::string At;
};

#endif
