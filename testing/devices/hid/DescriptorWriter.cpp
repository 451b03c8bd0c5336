// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/hid/DescriptorWriter.h"

namespace palpate::test
{

DescriptorWriter& DescriptorWriter::item(int type, int tag, std::uint32_t value, int bytes)
{
  const int size = bytes == 4 ? 3 : bytes;
  this->bytes_.push_back(static_cast<std::uint8_t>(tag << 4 | type << 2 | size));
  for (int i = 0; i < bytes; ++i)
  {
    this->bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  return *this;
}

DescriptorWriter& DescriptorWriter::number(int type, int tag, std::int64_t value)
{
  const bool one = value >= -128 && value <= 127, two = value >= -32768 && value <= 32767;
  return this->item(type, tag, static_cast<std::uint32_t>(value), one ? 1 : two ? 2 : 4);
}

DescriptorWriter& DescriptorWriter::logical(std::int64_t min, std::int64_t max)
{
  return this->number(1, 1, min).number(1, 2, max);
}

DescriptorWriter& DescriptorWriter::physical(std::int64_t min, std::int64_t max)
{
  return this->number(1, 3, min).number(1, 4, max);
}

DescriptorWriter& DescriptorWriter::size(std::uint32_t bits, std::uint32_t count)
{
  return this->number(1, 7, bits).number(1, 9, count);
}

DescriptorWriter& DescriptorWriter::usage(std::uint16_t id)
{
  return this->item(2, 0, id, id < 256 ? 1 : 2);
}

DescriptorWriter& DescriptorWriter::usages(std::initializer_list<std::uint16_t> ids)
{
  for (const std::uint16_t id : ids)
  {
    this->usage(id);
  }
  return *this;
}

DescriptorWriter& DescriptorWriter::usageRange(std::uint16_t first, std::uint16_t last)
{
  return this->item(2, 1, first, 2).item(2, 2, last, 2);
}

DescriptorWriter& DescriptorWriter::main(HidReportKind kind, std::uint8_t flags)
{
  const int tag = kind == HidReportKind::Input ? 8 : kind == HidReportKind::Output ? 9 : 11;
  return this->item(0, tag, flags, 1);
}

} // namespace palpate::test
