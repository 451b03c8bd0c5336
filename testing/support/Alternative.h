// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include <boost/variant.hpp>

namespace palpate::test
{

/// The value of type T in the variant that CGAL returns, or null. CGAL's variants are Boost's up to CGAL 5, and the
/// standard library's from 6 on.
template<class T, class... Types>
[[nodiscard]] const T* alternative(const boost::variant<Types...>& found)
{
  return boost::get<T>(&found);
}

template<class T, class... Types>
[[nodiscard]] const T* alternative(const std::variant<Types...>& found)
{
  return std::get_if<T>(&found);
}

} // namespace palpate::test
