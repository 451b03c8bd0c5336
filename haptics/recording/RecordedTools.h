// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/recording/ByteStream.h"
#include "haptics/tool/servo/ToolContacts.h"

namespace palpate
{

/// The payload of the chunk of a tool's contacts.
void putTool(ByteWriter& payload, const ToolContacts& contacts);
/// Of no use, with in.ok() false, where the bytes are none.
/// `version` of the chunk: the first one knew no balls.
[[nodiscard]] ToolContacts readTool(ByteReader& in, std::uint32_t version);

} // namespace palpate
