# state file generated using paraview version 5.13.2
import paraview
paraview.compatibility.major = 5
paraview.compatibility.minor = 13

#### import the simple module from the paraview
from paraview.simple import *
#### disable automatic camera reset on 'Show'
paraview.simple._DisableFirstRenderCameraReset()

# ----------------------------------------------------------------
# setup views used in the visualization
# ----------------------------------------------------------------

# Create a new 'Render View'
renderView1 = CreateView('RenderView')
renderView1.ViewSize = [467, 537]
renderView1.AxesGrid = 'Grid Axes 3D Actor'
renderView1.CenterOfRotation = [3.0, 0.0, 0.0]
renderView1.StereoType = 'Crystal Eyes'
renderView1.CameraPosition = [3.0, 0.0, 381.6079703803509]
renderView1.CameraFocalPoint = [3.0, 0.0, 0.0]
renderView1.CameraFocalDisk = 1.0
renderView1.CameraParallelScale = 99.58364921461317
renderView1.LegendGrid = 'Legend Grid Actor'
renderView1.PolarGrid = 'Polar Grid Actor'

SetActiveView(None)

# ----------------------------------------------------------------
# setup view layouts
# ----------------------------------------------------------------

# create new layout object 'Layout #1'
layout1 = CreateLayout(name='Layout #1')
layout1.AssignView(0, renderView1)
layout1.SetSize(467, 537)

# ----------------------------------------------------------------
# restore active view
SetActiveView(renderView1)
# ----------------------------------------------------------------

# ----------------------------------------------------------------
# setup the data processing pipelines
# ----------------------------------------------------------------

# create a new 'Box'
box = Box(registrationName='Box')
box.XLength = 100.0
box.YLength = 100.0
box.ZLength = 100.0

# ----------------------------------------------------------------
# setup the visualization in view 'renderView1'
# ----------------------------------------------------------------

# show data from box
boxDisplay = Show(box, renderView1, 'GeometryRepresentation')

# trace defaults for the display properties.
boxDisplay.Representation = 'Surface'
boxDisplay.ColorArrayName = [None, '']
boxDisplay.SelectNormalArray = 'Normals'
boxDisplay.SelectTangentArray = 'None'
boxDisplay.SelectTCoordArray = 'TCoords'
boxDisplay.TextureTransform = 'Transform2'
boxDisplay.Translation = [3.0, 0.0, 0.0]
boxDisplay.OSPRayScaleArray = 'Normals'
boxDisplay.OSPRayScaleFunction = 'Piecewise Function'
boxDisplay.Assembly = ''
boxDisplay.SelectedBlockSelectors = ['']
boxDisplay.SelectOrientationVectors = 'None'
boxDisplay.ScaleFactor = 10.0
boxDisplay.SelectScaleArray = 'None'
boxDisplay.GlyphType = 'Arrow'
boxDisplay.GlyphTableIndexArray = 'None'
boxDisplay.GaussianRadius = 0.5
boxDisplay.SetScaleArray = ['POINTS', 'Normals']
boxDisplay.ScaleTransferFunction = 'Piecewise Function'
boxDisplay.OpacityArray = ['POINTS', 'Normals']
boxDisplay.OpacityTransferFunction = 'Piecewise Function'
boxDisplay.DataAxesGrid = 'Grid Axes Representation'
boxDisplay.PolarAxes = 'Polar Axes Representation'
boxDisplay.SelectInputVectors = ['POINTS', 'Normals']
boxDisplay.WriteLog = ''

# init the 'Piecewise Function' selected for 'ScaleTransferFunction'
boxDisplay.ScaleTransferFunction.Points = [-1.0, 0.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]

# init the 'Piecewise Function' selected for 'OpacityTransferFunction'
boxDisplay.OpacityTransferFunction.Points = [-1.0, 0.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]

# init the 'Polar Axes Representation' selected for 'PolarAxes'
boxDisplay.PolarAxes.Translation = [3.0, 0.0, 0.0]

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
animationScene1.ViewModules = renderView1
animationScene1.Cues = timeAnimationCue1
animationScene1.AnimationTime = 0.0

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
## https://www.paraview.org/paraview-docs/latest/python/paraview.simple.html
##--------------------------------------------
# touched sources and tool, and what it feels like
haptics = servermanager.ProxyManager().GetProxy('haptics', 'HapticSession')
if haptics:
    haptics.SetPropertyWithName('SourcesText', 'Source,Touched,Stiffness,FrictionStatic,FrictionKinetic\nBox,1,250,-1,-1\n')
    haptics.SetPropertyWithName('Stiffness', 400.0)
    haptics.SetPropertyWithName('VirtualTime', 1)
