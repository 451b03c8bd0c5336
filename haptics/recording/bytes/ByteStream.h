// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate
{

static_assert(std::endian::native == std::endian::little, "recordings are little-endian");

/// A type of several members that membersOf(visit, object) hands to visit(member) one after the other.
template<class T>
concept HasMembers = requires(T& object)
{
  membersOf([](auto& /*member*/) {}, object);
};

/// Appends numbers to a byte string, as they lie in memory on a little-endian machine.
class ByteWriter
{
public:
  template<HasMembers T>
  void put(const T& object)
  {
    membersOf([this](const auto& member) { this->put(member); }, object);
  }
  template<class T>
  void put(const T& value)
  {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    const char* const bytes = reinterpret_cast<const char*>(&value);
    this->bytes_.insert(this->bytes_.end(), bytes, bytes + sizeof(T));
  }
  void put(const Vec3& v)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->put(v[k]);
    }
  }
  void put(const Quat& q)
  {
    for (int k = 0; k < 4; ++k)
    {
      this->put(q.coeffs()[k]);
    }
  }
  void put(const Pose& pose)
  {
    this->put(pose.p);
    this->put(pose.q);
  }
  template<class T, std::size_t N>
  void put(const std::array<T, N>& values)
  {
    for (const T& value : values)
    {
      this->put(value);
    }
  }
  /// After their count.
  template<class T>
  void put(const std::vector<T>& values)
  {
    this->put(static_cast<std::uint64_t>(values.size()));
    for (const T& value : values)
    {
      this->put(value);
    }
  }
  void put(const std::optional<double>& number)
  {
    this->put(number.has_value());
    this->put(number.value_or(0.0));
  }
  void put(const std::string& text)
  {
    this->put(static_cast<std::uint32_t>(text.size()));
    this->bytes_.insert(this->bytes_.end(), text.begin(), text.end());
  }
  [[nodiscard]] const std::vector<char>& bytes() const { return this->bytes_; }

private:
  std::vector<char> bytes_;
};

/// Takes numbers off a range of bytes that is not trusted: past the end it gives zeros and ok() is false.
class ByteReader
{
public:
  ByteReader(const char* begin, std::size_t size) : at_(begin), left_(size) {}

  template<HasMembers T>
  void get(T& object)
  {
    membersOf([this](auto& member) { this->get(member); }, object);
  }
  template<class T>
  void get(T& value)
  {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    value = T{};
    if (this->has(sizeof(T)))
    {
      std::memcpy(&value, this->at_, sizeof(T));
      this->skip(sizeof(T));
    }
  }
  void get(bool& value)
  {
    std::uint8_t byte = 0;
    this->get(byte);
    this->ok_ = this->ok_ && byte <= 1;
    value = byte == 1;
  }
  void get(Vec3& v)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->get(v[k]);
    }
  }
  void get(Quat& q)
  {
    for (int k = 0; k < 4; ++k)
    {
      this->get(q.coeffs()[k]);
    }
  }
  void get(Pose& pose)
  {
    this->get(pose.p);
    this->get(pose.q);
  }
  template<class T, std::size_t N>
  void get(std::array<T, N>& values)
  {
    for (T& value : values)
    {
      this->get(value);
    }
  }
  /// Their type has the size in memory that it has in the bytes.
  template<class T>
  void get(std::vector<T>& values)
  {
    values.resize(this->count(sizeof(T)));
    for (T& value : values)
    {
      this->get(value);
    }
  }
  void get(std::optional<double>& number)
  {
    bool there = false;
    this->get(there);
    this->get(number.emplace());
    number = there ? number : std::nullopt;
  }
  void get(std::string& text)
  {
    std::uint32_t size = 0;
    this->get(size);
    text.clear();
    if (this->has(size))
    {
      text.assign(this->at_, size);
      this->skip(size);
    }
  }
  /// A count of things of at least `bytesEach`: refused if they cannot all be there.
  [[nodiscard]] std::uint64_t count(std::size_t bytesEach)
  {
    std::uint64_t n = 0;
    this->get(n);
    this->ok_ = this->ok_ && n <= this->left_ / bytesEach;
    return this->ok_ ? n : 0;
  }
  [[nodiscard]] bool has(std::size_t size)
  {
    this->ok_ = this->ok_ && size <= this->left_;
    return this->ok_;
  }
  [[nodiscard]] const char* at() const { return this->at_; }
  void skip(std::size_t size)
  {
    this->at_ += size;
    this->left_ -= size;
  }
  void fail() { this->ok_ = false; }
  void failUnless(bool holds) { this->ok_ = this->ok_ && holds; }
  [[nodiscard]] bool ok() const { return this->ok_; }
  [[nodiscard]] std::size_t left() const { return this->left_; }

private:
  const char* at_;
  std::size_t left_;
  bool ok_ = true;
};

} // namespace palpate
