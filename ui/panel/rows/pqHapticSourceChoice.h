// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticSourceChoice_h
#define pqHapticSourceChoice_h

#include <QComboBox>
#include <QPointer>
#include <QTimer>

class pqPipelineSource;
class pqServerManagerModelItem;

/**
 * A list of the sources of the pipeline, with the icons of the pipeline browser, of which one or none is chosen.
 *
 * Only sources that fit the property are listed, and sources that have made nothing yet. The chosen source stays chosen
 * under its new name when it is renamed, and stays in the list when it is deleted: a state file may name a source
 * before that source exists.
 */
class pqHapticSourceChoice : public QComboBox
{
  Q_OBJECT
  typedef QComboBox Superclass;

  /// Name of the chosen source; empty: none.
  Q_PROPERTY(QString source READ source WRITE setSource NOTIFY sourceChanged)

public:
  /// `property`: of the session, by which the sources that fit are known.
  pqHapticSourceChoice(QWidget* parent, const QString& property);
  ~pqHapticSourceChoice() override;

  QString source() const { return this->Name; }
  void setSource(const QString& name);

Q_SIGNALS:
  /// A person is choosing; sourceChanged() follows.
  void chosen();
  void sourceChanged();

protected:
  void showEvent(QShowEvent* event) override;

private:
  void listSources();
  void take(int index);
  void follow(pqServerManagerModelItem* renamed);
  bool fits(pqPipelineSource* source) const;

  QString Property;
  QString Name; ///< never null: a null string is never sent to a property
  QPointer<pqPipelineSource> Chosen;
  QTimer Listing;
};

#endif
