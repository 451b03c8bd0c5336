// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/arm/BoardModel.h"

#include <algorithm>

namespace palpate::test
{

void BoardModel::say(std::vector<std::uint8_t> answer)
{
  ++this->answers;
  if (this->frozen || this->silentFor > 0)
  {
    this->silentFor -= this->silentFor > 0 ? 1 : 0;
    return;
  }
  if (this->cutAnswers > 0)
  {
    --this->cutAnswers;
    answer.resize(answer.size() / 2);
  }
  if (this->wrongAnswers > 0)
  {
    --this->wrongAnswers;
    std::fill(answer.begin(), answer.end(), std::uint8_t{ 0xFF });
  }
  this->said.insert(this->said.end(), answer.begin(), answer.end());
}

} // namespace palpate::test
