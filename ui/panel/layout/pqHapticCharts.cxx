// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticCharts.h"

#include "pqHapticFields.h"
#include "pqHapticStrip.h"
#include "vtkHapticSession.h"

#include <QVBoxLayout>

namespace
{
constexpr double milliOfOne = 1e3; // m to mm, J to mJ
constexpr int betweenStrips = 3;   // [pixels]

/// The names of surfaces and field alone: a surface that moves or bends is the same.
QStringList FeltOf(const vtkHapticSession* session, const QString& report)
{
  QStringList felt;
  for (const QString& line : report.split('\n'))
  {
    felt << (line.startsWith("Touching ") ? QStringList(line) : QStringList());
  }
  return felt << (session ? QString::fromUtf8(session->GetFieldName()) : QString());
}
} // namespace

pqHapticCharts::pqHapticCharts(QWidget* parent) : Superclass(parent)
{
  this->setObjectName("charts");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(betweenStrips);
  this->Force = this->add(column, "forceStrip", tr("Force"), "N", pqHapticReadoutTip("ForceMagnitude"));
  this->Depth = this->add(column, "depthStrip", tr("Depth"), "mm",
    tr("Distance from the hand to the proxy; for a held wire the stretch of the spring of the hand, as displacement of "
       "the device"));
  this->Lateness = this->add(column, "latenessStrip", tr("Lateness"), "ms", pqHapticReadoutTip("LatenessP99"));
  this->Energy = this->add(column, "energyStrip", tr("Excess energy"), "mJ", pqHapticReadoutTip("ExcessEnergy"));
}

pqHapticCharts::~pqHapticCharts() = default;

pqHapticStrip* pqHapticCharts::add(
  QVBoxLayout* column, const char* name, const QString& title, const char* unit, const QString& tip)
{
  auto* strip = new pqHapticStrip(this, name, title, unit, 1.0);
  strip->setToolTip(tip);
  column->addWidget(strip);
  return strip;
}

void pqHapticCharts::clear()
{
  for (pqHapticStrip* strip : { this->Force, this->Depth, this->Lateness, this->Energy })
  {
    strip->clear();
  }
}

void pqHapticCharts::refresh(vtkHapticSession* session, const QString& report)
{
  const bool touches = session && session->GetTouching();
  const QStringList scene = FeltOf(session, report);
  if (touches && (!this->Touched || scene != this->Scene))
  {
    this->clear();
  }
  this->Touched = touches;
  this->Scene = scene;
  if (!touches)
  {
    for (pqHapticStrip* strip : { this->Force, this->Depth, this->Lateness, this->Energy })
    {
      strip->setLast();
    }
    return;
  }
  this->Force->add(session->GetForceMagnitude());
  this->Depth->add(session->GetContacts() > 0 ? milliOfOne * session->GetDepth() / session->GetSetting("Scale") : 0.0);
  this->Lateness->add(session->GetLatenessP99() / milliOfOne);
  this->Energy->add(milliOfOne * session->GetExcessEnergy());
}
