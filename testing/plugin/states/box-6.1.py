# state file generated using paraview version 6.1.1
import paraview
paraview.compatibility.major = 6
paraview.compatibility.minor = 1

#### import the simple module from the paraview
from paraview.simple import *
#### disable automatic camera reset on 'Show'
paraview.simple._DisableFirstRenderCameraReset()

# ----------------------------------------------------------------
# setup views used in the visualization
# ----------------------------------------------------------------

# Create a new 'Render View'
renderView1 = CreateView('RenderView')
renderView1.Set(
    ViewSize=[428, 536],
    CenterOfRotation=[3.0, 0.0, 0.0],
    StereoType='Crystal Eyes',
    CameraPosition=[3.0, 0.0, 413.9225462740813],
    CameraFocalPoint=[3.0, 0.0, 0.0],
    CameraParallelScale=108.45551785711662,
    ANARIRendererParameters=['', '', ''],
)

SetActiveView(None)

# ----------------------------------------------------------------
# setup view layouts
# ----------------------------------------------------------------

# create new layout object 'Layout #1'
layout1 = CreateLayout(name='Layout #1')
layout1.AssignView(0, renderView1)
layout1.SetSize(428, 536)

# ----------------------------------------------------------------
# restore active view
SetActiveView(renderView1)
# ----------------------------------------------------------------

# ----------------------------------------------------------------
# setup the data processing pipelines
# ----------------------------------------------------------------

# create a new 'Box'
box = Box(registrationName='Box')
box.Set(
    XLength=100.0,
    YLength=100.0,
    ZLength=100.0,
)

# ----------------------------------------------------------------
# setup the visualization in view 'renderView1'
# ----------------------------------------------------------------

# show data from box
boxDisplay = Show(box, renderView1, 'GeometryRepresentation')

# trace defaults for the display properties.
boxDisplay.Set(
    Representation='Surface',
    ColorArrayName=[None, ''],
    SelectNormalArray='Normals',
    SelectTCoordArray='TCoords',
    Translation=[3.0, 0.0, 0.0],
    OSPRayScaleArray='Normals',
    ScaleFactor=10.0,
    GaussianRadius=0.5,
    SetScaleArray=['POINTS', 'Normals'],
    OpacityArray=['POINTS', 'Normals'],
    SelectInputVectors=['POINTS', 'Normals'],
)

# init the 'Piecewise Function' selected for 'ScaleTransferFunction'
boxDisplay.ScaleTransferFunction.Points = [-1.0, 0.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]

# init the 'Piecewise Function' selected for 'OpacityTransferFunction'
boxDisplay.OpacityTransferFunction.Points = [-1.0, 0.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]

# init the 'Polar Axes Representation' selected for 'PolarAxes'
boxDisplay.PolarAxes.Set(
    MaximumRadius=100.0,
    Translation=[3.0, 0.0, 0.0],
)

# ----------------------------------------------------------------
# setup animation scene, tracks and keyframes
# note: the Get..() functions create a new object, if needed
# ----------------------------------------------------------------

# get time animation track
timeAnimationCue1 = GetTimeTrack()

# initialize the animation scene

# get the time-keeper
timeKeeper1 = GetTimeKeeper()

# initialize the timekeeper

# initialize the animation track

# get animation scene
animationScene1 = GetAnimationScene()

# initialize the animation scene
animationScene1.Set(
    ViewModules=renderView1,
    Cues=timeAnimationCue1,
    AnimationTime=0.0,
)

# ----------------------------------------------------------------
# restore active source
SetActiveSource(box)
# ----------------------------------------------------------------


##--------------------------------------------
## You may need to add some code at the end of this python script depending on your usage, eg:
#
## Render all views to see them appears
# RenderAllViews()
#
## Interact with the view, usefull when running from pvpython
# Interact()
#
## Save a screenshot of the active view
# SaveScreenshot("path/to/screenshot.png")
#
## Save a screenshot of a layout (multiple splitted view)
# SaveScreenshot("path/to/screenshot.png", GetLayout())
#
## Save all "Extractors" from the pipeline browser
# SaveExtracts()
#
## Save a animation of the current active view
# SaveAnimation()
#
## Please refer to the documentation of paraview.simple
## https://www.paraview.org/paraview-docs/nightly/python/
##--------------------------------------------
# touched sources and tool, and what it feels like
haptics = servermanager.ProxyManager().GetProxy('haptics', 'HapticSession')
if haptics:
    haptics.SetPropertyWithName('SourcesText', 'Source,Touched,Stiffness,FrictionStatic,FrictionKinetic\nBox,1,250,-1,-1\n')
    haptics.SetPropertyWithName('Stiffness', 400.0)
    haptics.SetPropertyWithName('VirtualTime', 1)
