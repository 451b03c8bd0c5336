// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticProgress.h"

#include "pqHapticController.h"
#include "vtkHapticSession.h"
#include "vtkSMProxy.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>

namespace
{
/// Looks at the session: progress that ends sooner would only flicker.
constexpr int patience = 3;
constexpr double percent = 100.0;
} // namespace

pqHapticProgress::pqHapticProgress(QWidget* parent)
  : Superclass(parent), Bar(new QProgressBar(this)), Cancel(new QPushButton(tr("Cancel"), this))
{
  this->setObjectName("progress");
  this->Bar->setObjectName("bar");
  this->Bar->setRange(0, static_cast<int>(percent));
  this->Bar->setFormat(tr("Preparing %p %"));
  this->Bar->setToolTip(tr("Share of the visible data that is ready to be touched"));
  this->Cancel->setObjectName("cancel");
  this->Cancel->setToolTip(tr("Stop preparing the visible data, and continue to touch the previous scene"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(this->Bar, 1);
  row->addWidget(this->Cancel);
  this->connect(this->Cancel, &QPushButton::clicked, this,
    []
    {
      if (vtkSMProxy* const proxy = pqHapticController::instance()->sessionProxy())
      {
        proxy->InvokeCommand("CancelScene");
      }
    });
}

pqHapticProgress::~pqHapticProgress() = default;

void pqHapticProgress::refresh(vtkHapticSession* session)
{
  const double share = session ? session->GetSceneProgress() : 1.0;
  this->Waited = share < 1.0 ? this->Waited + 1 : 0;
  this->Bar->setValue(static_cast<int>(percent * share));
}

bool pqHapticProgress::waits() const
{
  return this->Waited >= patience;
}

QWidget* pqHapticProgress::field() const
{
  return this->Cancel;
}
