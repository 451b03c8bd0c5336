// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of a server: how much of them is fetched, and what is there.
#include "vtkHapticSessionInternals.h"

vtkHapticServerSurfaces& vtkHapticSession::ServerSurfaces() const
{
  this->Impl->Server.SetHand(this->Impl->Hand_W);
  return this->Impl->Server;
}

void vtkHapticSession::SetServerLimit(int limit)
{
  if (this->Allows("ServerLimit", { static_cast<double>(limit) }) && limit != this->Impl->Server.GetLimit())
  {
    this->Impl->Server.SetLimit(limit);
    this->Modified();
  }
}

int vtkHapticSession::GetServerLimit() const
{
  return this->Impl->Server.GetLimit();
}

const char* vtkHapticSession::GetServerSentence() const
{
  return this->Impl->Server.GetSentence().c_str();
}

double vtkHapticSession::GetServerAge() const
{
  return this->Impl->Server.GetAge();
}

vtkIdType vtkHapticSession::GetServerTicksBeyond() const
{
  return static_cast<vtkIdType>(this->Impl->State.known.beyondTicks);
}
