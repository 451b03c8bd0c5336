// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticSourceChoice.h"

#include "pqApplicationCore.h"
#include "pqPipelineModel.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "vtkHapticSourceParts.h"
#include "vtkSMSourceProxy.h"

#include <QMap>
#include <QSignalBlocker>

namespace
{
/// A pipeline that runs all the time, for a soft body that bends for example, has its sources looked at so often.
constexpr int betweenLooks_ms = 200;

pqServerManagerModel* Model()
{
  return pqApplicationCore::instance()->getServerManagerModel();
}

pqPipelineSource* SourceNamed(const QString& name)
{
  for (pqPipelineSource* const source : Model()->findItems<pqPipelineSource*>())
  {
    if (source->getSMName() == name)
    {
      return source;
    }
  }
  return nullptr;
}
} // namespace

pqHapticSourceChoice::pqHapticSourceChoice(QWidget* parent, const QString& property)
  : Superclass(parent), Property(property), Name("")
{
  this->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon); // a long name makes no wide panel
  this->Listing.setSingleShot(true);
  this->connect(&this->Listing, &QTimer::timeout, this, &pqHapticSourceChoice::listSources);
  this->connect(this, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &pqHapticSourceChoice::take);
  const auto listSoon = [this] { this->Listing.start(0); };
  this->connect(Model(), &pqServerManagerModel::sourceAdded, this, listSoon);
  this->connect(Model(), &pqServerManagerModel::sourceRemoved, this, listSoon);
  this->connect(Model(), &pqServerManagerModel::nameChanged, this, &pqHapticSourceChoice::follow);
  const auto lookSoon = [this]
  {
    if (this->isVisible() && !this->Listing.isActive())
    {
      this->Listing.start(betweenLooks_ms);
    }
  };
  this->connect(Model(), &pqServerManagerModel::dataUpdated, this, lookSoon);
  this->listSources();
}

pqHapticSourceChoice::~pqHapticSourceChoice() = default;

void pqHapticSourceChoice::setSource(const QString& name)
{
  if (name != this->Name)
  {
    this->Name = name.isNull() ? QString("") : name;
    this->listSources();
    Q_EMIT this->sourceChanged();
  }
}

void pqHapticSourceChoice::showEvent(QShowEvent* event)
{
  this->listSources();
  this->Superclass::showEvent(event);
}

bool pqHapticSourceChoice::fits(pqPipelineSource* source) const
{
  static const QMap<QString, vtkHapticTouchKind> kinds = {
    { "ToolSource", vtkHapticTouchKind::Tool },
    { "SoftSource", vtkHapticTouchKind::Tissue },
    { "MechanismSource", vtkHapticTouchKind::Mechanism },
    { "FeltSource", vtkHapticTouchKind::Field },
    { "CompareSource", vtkHapticTouchKind::Field },
  };
  const auto kind = kinds.find(this->Property);
  return kind == kinds.end() || vtkHapticMisfit(vtkHapticPartsOf(source->getSourceProxy()), *kind).empty();
}

void pqHapticSourceChoice::listSources()
{
  this->Chosen = this->Name.isEmpty() ? nullptr : SourceNamed(this->Name);
  const QSignalBlocker nothingWasChosen(this);
  const pqPipelineModel pipeline(*Model());
  this->clear();
  this->addItem(tr("none"), QString(""));
  for (pqPipelineSource* const source : Model()->findItems<pqPipelineSource*>())
  {
    if (source == this->Chosen || this->fits(source))
    {
      this->addItem(source->getSMName(), source->getSMName());
      const QVariant icon = pipeline.data(pipeline.getIndexFor(source), Qt::DecorationRole);
      this->setItemData(this->count() - 1, icon, Qt::DecorationRole);
    }
  }
  if (!this->Name.isEmpty() && !this->Chosen)
  {
    this->addItem(tr("%1 (not there)").arg(this->Name), this->Name);
  }
  this->setCurrentIndex(this->findData(this->Name));
}

void pqHapticSourceChoice::take(int index)
{
  this->Name = index > 0 ? this->itemData(index).toString() : QString("");
  this->Chosen = index > 0 ? SourceNamed(this->Name) : nullptr;
  Q_EMIT this->chosen();
  Q_EMIT this->sourceChanged();
}

void pqHapticSourceChoice::follow(pqServerManagerModelItem* renamed)
{
  auto* const source = qobject_cast<pqPipelineSource*>(renamed);
  if (source && source == this->Chosen)
  {
    this->setSource(source->getSMName());
  }
  this->Listing.start(0);
}
