// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace palpate::test
{

/// Places of the file system that a program finds elsewhere, by the functions of the system that FakeFiles.cpp puts
/// before the system's own. They stay so from the making of this object, of which there is one and which must last.
class FakeFiles
{
public:
  /// The beginning of a path, and the one that is used instead.
  using Place = std::pair<std::string, std::string>;

  explicit FakeFiles(std::vector<Place> places);
  FakeFiles(const FakeFiles&) = delete;
  FakeFiles& operator=(const FakeFiles&) = delete;

  [[nodiscard]] std::string pathOf(const std::string& path) const;

private:
  std::vector<Place> places_;
};

} // namespace palpate::test
