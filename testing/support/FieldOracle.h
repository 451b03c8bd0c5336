// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/field/iso/IsoProxy.h"

namespace palpate::test
{

/// Watches the path of an isosurface's proxy in numbers of 113 bits, by cells and cubics of its own.
class FieldOracle final : public FieldPathSink
{
public:
  explicit FieldOracle(const FieldBlockComponent& field) noexcept : field_(field) {}

  void piece(const GridPlace& from, const GridPlace& to, double level, double side) noexcept override;

  /// Largest |f - level| of the field's points.
  [[nodiscard]] double largest(double level) const noexcept;
  /// side (f - level), rounded to double once it is known.
  [[nodiscard]] double value(const GridPlace& at, double level, double side) const noexcept;

  std::uint64_t pieces = 0;
  std::uint64_t crossed = 0;   ///< pieces that somewhere are below -1e-12 of the largest |f - level|
  std::uint64_t wrongEnds = 0; ///< that end below 0

private:
  FieldBlockComponent field_;
  mutable double largestLevel_ = 0.0, largest_ = -1.0;
};

} // namespace palpate::test
