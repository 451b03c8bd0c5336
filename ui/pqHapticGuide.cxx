// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticGuide.h"

#include "vtkHapticGallery.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QObject>
#include <QUrl>

QString pqHapticOpenGuide(const QString& page)
{
  // The guide lies beside the gallery, in a build tree and where the plugin is installed.
  const QDir shared(QString::fromStdString(vtkHapticGallery::Folder()) + "/..");
  const QString file = QDir::cleanPath(shared.filePath("guide/panel-" + page + ".html"));
  if (vtkHapticGallery::Folder().empty() || !QFileInfo::exists(file))
  {
    return QObject::tr(
      "The guide is not installed with this plugin (%1 is missing). Install python3-markdown and build "
      "again, or read docs/ of the sources.")
      .arg(file);
  }
  return QDesktopServices::openUrl(QUrl::fromLocalFile(file))
           ? QString()
           : QObject::tr("No browser could be started. Open this file: %1").arg(file);
}
