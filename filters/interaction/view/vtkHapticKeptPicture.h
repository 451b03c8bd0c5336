// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticKeptPicture_h
#define vtkHapticKeptPicture_h

#include "vtkHapticInteractionModule.h"
#include "vtkNew.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRenderer;

/**
 * The picture of the data, kept below a hand that moves in front of it: colours and depths of the layers below the
 * renderer of the hand, taken each time these are drawn. Until something of them changes, a picture of the hand's new
 * place costs the hand alone, however many triangles the data have. Rendering thread only.
 */
class VTKHAPTICINTERACTION_EXPORT vtkHapticKeptPicture
{
public:
  vtkHapticKeptPicture();
  ~vtkHapticKeptPicture();
  vtkHapticKeptPicture(const vtkHapticKeptPicture&) = delete;
  vtkHapticKeptPicture& operator=(const vtkHapticKeptPicture&) = delete;

  /// The renderer of the hand, on a layer above the data's; null: nothing is kept, and the kept picture is released.
  void SetRenderer(vtkRenderer* hand);

  /// Whether a kept picture shows the layers below as they would be drawn now: the same window, cameras, lights, props
  /// and data, none of which was modified since. Data that wait to be handed to a mapper, and a renderer's own settings
  /// (its background), are the caller's to know.
  bool IsCurrent() const;

  /// Draws the kept picture and the hand's layer in front of it. Call it only while IsCurrent().
  void DrawHand();

private:
  void LayersAreDrawn();
  void Keep(vtkOpenGLRenderWindow& window);
  void PutBack(vtkOpenGLRenderWindow& window);
  void Release();
  bool Holds() const;
  vtkOpenGLRenderWindow* Window() const;

  vtkWeakPointer<vtkRenderer> Hand;
  vtkNew<vtkOpenGLFramebufferObject> Kept;
  vtkTimeStamp KeptAt;
  int Size[2] = { 0, 0 }; ///< of the kept picture [pixels]; 0: none is kept
  int Samples = 0;        ///< of a pixel of the kept picture
  unsigned long Observer = 0;
  bool PuttingBack = false;
};

#endif
