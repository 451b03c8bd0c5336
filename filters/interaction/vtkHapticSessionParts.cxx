// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSessionInternals.h"

#include "vtkHapticCheckState.h"
#include "vtkHapticContactState.h"
#include "vtkHapticGameState.h"
#include "vtkHapticHeldMechanism.h"
#include "vtkHapticPressedBody.h"
#include "vtkHapticRecordings.h"
#include "vtkHapticSceneSurfaces.h"
#include "vtkHapticServerSurfaces.h"
#include "vtkHapticTool.h"

/// The parts that have a folder of their own.
struct vtkHapticSession::Internals::Parts
{
  explicit Parts(Internals& session) : Server(session.Core, session.Scene, Surfaces), Recorded(session) {}

  vtkHapticSceneSurfaces Surfaces;
  vtkHapticServerSurfaces Server;
  vtkHapticTool Tool;
  vtkHapticPressedBody Soft;
  vtkHapticHeldMechanism Mechanism;
  vtkHapticCheckState Check;
  vtkHapticContactState Contact;
  vtkHapticGameState Game;
  vtkHapticRecordings Recorded;
};

vtkHapticSession::Internals::Internals(vtkHapticSession& session)
  : Session(session), Owned(std::make_unique<Parts>(*this)), Surfaces(Owned->Surfaces), Server(Owned->Server),
    Tool(Owned->Tool), Soft(Owned->Soft), Mechanism(Owned->Mechanism), Check(Owned->Check), Contact(Owned->Contact),
    Game(Owned->Game), Recorded(Owned->Recorded), FeltSources{ &Owned->Tool, &Owned->Soft, &Owned->Mechanism }
{
}

vtkHapticSession::Internals::~Internals() = default;
