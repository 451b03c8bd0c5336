// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticGuide_h
#define pqHapticGuide_h

#include <QString>

/**
 * Opens the guide that is installed with the plugin in the person's browser, without a network.
 *
 * `page`: the name of a page of the panel, for example "field", whose help is opened. docs/guide/make.py writes a file
 * for each, panel-field.html, that leads to the heading. Returns "" once the browser was asked, or a sentence that says
 * why there is no guide, and the remedy.
 */
[[nodiscard]] QString pqHapticOpenGuide(const QString& page);

#endif
