// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

namespace palpate
{

/// A library of a vendor's that is looked for when the program runs. Its functions are declared by hand.
class SharedLibrary
{
public:
  /// Loads it; problem() says why it cannot be used.
  explicit SharedLibrary(const std::string& name);

  /// False: it is not installed at all.
  [[nodiscard]] bool found() const noexcept { return this->handle_ != nullptr; }
  /// Puts the address of a function where it is called through; the first that is missing is named by problem().
  template<class Function>
  void take(const char* name, Function*& function)
  {
    function = reinterpret_cast<Function*>(this->address(name));
  }
  /// The same for a function that may be missing; null where it is.
  template<class Function>
  void takeIfThere(const char* name, Function*& function)
  {
    function = reinterpret_cast<Function*>(this->sought(name));
  }
  /// Empty: everything that was taken is there.
  [[nodiscard]] const std::string& problem() const noexcept { return this->problem_; }

private:
  [[nodiscard]] void* sought(const char* name) const;
  [[nodiscard]] void* address(const char* name);

  std::string name_;
  std::shared_ptr<void> handle_;
  std::string problem_;
};

} // namespace palpate
