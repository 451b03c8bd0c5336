// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticFieldPacket_h
#define vtkHapticFieldPacket_h

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "vtkHapticFieldData.h"

/// The part of a field that a server sends.
struct vtkHapticFieldPacket
{
  std::string Problem; ///< why it cannot be felt; "": it can
  palpate::FieldEnds Ends{ 1.0, 0.0 };
  std::array<double, 6> Bounds{}; ///< [u]
  palpate::MadeFieldBlock Made;
};

/// As bytes; a block in them is the same to the bit.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::vector<char> vtkHapticPackField(const vtkHapticFieldPacket& packet);
/// None where the bytes have another form.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::optional<vtkHapticFieldPacket> vtkHapticUnpackField(
  std::span<const char> bytes);

#endif
