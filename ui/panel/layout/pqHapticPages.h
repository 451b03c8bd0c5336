// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticPages_h
#define pqHapticPages_h

#include <QList>
#include <QMap>
#include <QString>
#include <QWidget>

#include <vector>

class QLabel;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

/**
 * The pages of the panel: a list of their titles, always visible, and beside it the rows of one of them, or of all of
 * them while a search shows its results.
 *
 * A page without a use now is grey in the list, and its tip gives the reason; it can be opened like the others.
 */
class pqHapticPages : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

public:
  explicit pqHapticPages(QWidget* parent = nullptr);
  ~pqHapticPages() override;

  /// The page is named `name` and "Page", its button `name` and "Button". The first page is shown at the start.
  QVBoxLayout* add(const QString& name, const QString& title, const QString& tip);
  /// By the names of pages, why they have no use now; "" where they have one.
  void setReasons(const QMap<QString, QString>& reasons);
  QList<QWidget*> pages() const;
  /// The name of the page that was chosen last.
  QString chosenName() const;
  /// All pages, or the one that was chosen last.
  void showAll(bool all);
  /// Below the rows that a search shows; "" without a search.
  void setNote(const QString& text);
  /// Wide enough for the widest page: nothing is cut off at the side, and no page changes the width.
  void fitWidth();
  /// In the order of the Tab key.
  QList<QWidget*> fields() const;

Q_SIGNALS:
  /// A page was chosen in the list.
  void chosen();

private:
  void setReason(const QString& name, const QString& reason);
  struct Page
  {
    QString Name, Tip;
    QToolButton* Button;
    QWidget* Body;
  };
  void choose(QWidget* page);

  std::vector<Page> All;
  QWidget* Chosen = nullptr;
  QScrollArea* Choice;
  QScrollArea* Scroll;
  QVBoxLayout* Buttons;
  QVBoxLayout* Column;
  QLabel* Note;
};

#endif
