# One scene of reference_bench in Blender's Cycles, as a process of its own: prints the mean over the
# mask, the mean variance between runs with different seeds, and seconds of processor time for one.
#
# MASK is what reference_bench wrote for the same scene: both average over the same pixels.
#
# blender -b --factory-startup -P cycles.py -- NAME MODEL.off PIXELS SAMPLES SEEDS MASK [best]
import math
import os
import sys
import tempfile

import bpy
import numpy

name, model, pixels, samples, seeds, mask_file = sys.argv[sys.argv.index("--") + 1 :][:6]
pixels, samples, seeds = int(pixels), int(samples), int(seeds)
best = sys.argv[-1] == "best"

bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene


def icosphere(radius):
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=6, radius=radius)
    return bpy.context.object


def from_off(path, diameter):
    words = open(path).read().split()
    vertices, faces = int(words[1]), int(words[2])
    p = numpy.array(words[4 : 4 + 3 * vertices], dtype=float).reshape(-1, 3)
    f = numpy.array(words[4 + 3 * vertices :][: 4 * faces], dtype=int).reshape(-1, 4)[:, 1:]
    p -= (p.min(axis=0) + p.max(axis=0)) / 2
    p *= diameter / 2 / numpy.sqrt((p * p).sum(axis=1)).max()
    p[:, [0, 2]] *= -1  # half a turn about the vertical
    mesh = bpy.data.meshes.new("model")
    mesh.from_pydata(p.tolist(), [], f.tolist())
    mesh.update()
    thing = bpy.data.objects.new("model", mesh)
    scene.collection.objects.link(thing)
    return thing


thing, diameter = (icosphere(5), 10) if name.startswith("sphere") else (from_off(model, 20), 20)

# Extinction 1, albedo 0.9, isotropic; the surface does nothing.
material = bpy.data.materials.new("medium")
material.use_nodes = True
nodes, links = material.node_tree.nodes, material.node_tree.links
nodes.clear()
output = nodes.new("ShaderNodeOutputMaterial")
scatter, absorb, both = (
    nodes.new("ShaderNodeVolumeScatter"),
    nodes.new("ShaderNodeVolumeAbsorption"),
    nodes.new("ShaderNodeAddShader"),
)
scatter.inputs["Color"].default_value = (1, 1, 1, 1)
scatter.inputs["Density"].default_value = 0.9
scatter.inputs["Anisotropy"].default_value = 0
absorb.inputs["Color"].default_value = (0, 0, 0, 1)
absorb.inputs["Density"].default_value = 0.1
links.new(scatter.outputs[0], both.inputs[0])
links.new(absorb.outputs[0], both.inputs[1])
links.new(both.outputs[0], output.inputs["Volume"])
thing.data.materials.clear()
thing.data.materials.append(material)

world = bpy.data.worlds.new("sky")
scene.world = world
world.use_nodes = True
background = world.node_tree.nodes["Background"]
background.inputs["Color"].default_value = (1, 1, 1, 1)
background.inputs["Strength"].default_value = 1 if name == "sphere-sky" else 0
if name != "sphere-sky":
    lamp = bpy.data.lights.new("sun", "SUN")
    lamp.angle, lamp.energy = 0, 1
    sun = bpy.data.objects.new("sun", lamp)
    # a lamp shines along its -z: turn that away from (0, 0.3, -1)
    sun.rotation_euler = (-(math.pi - math.atan2(0.3, 1)), 0, 0)
    scene.collection.objects.link(sun)

camera = bpy.data.cameras.new("camera")
camera.angle = math.radians(30)
camera.clip_end = 1000
eye = bpy.data.objects.new("camera", camera)
eye.location = (0, 0, 1.04 * diameter / 2 / math.sin(math.radians(15)))
scene.collection.objects.link(eye)
scene.camera = eye

scene.render.engine = "CYCLES"
cycles = scene.cycles
cycles.device = "CPU"
cycles.samples = samples
cycles.use_adaptive_sampling = False
cycles.use_denoising = False
cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
cycles.volume_bounces = cycles.max_bounces = 1024
cycles.transparent_max_bounces = 1024
cycles.pixel_filter_type = "BOX"
if best:
    cycles.sampling_pattern = "SOBOL"
    cycles.light_sampling_threshold = 0
scene.render.resolution_x = scene.render.resolution_y = pixels
scene.render.resolution_percentage = 100
scene.render.threads_mode, scene.render.threads = "FIXED", 2
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
scene.render.filepath = os.path.join(tempfile.mkdtemp(), "picture.exr")


def render(seed, count):
    cycles.seed, cycles.samples = seed, count
    before = os.times()
    bpy.ops.render.render(write_still=True)
    after = os.times()
    image = bpy.data.images.load(scene.render.filepath)
    values = numpy.array(image.pixels[:]).reshape(pixels, pixels, 4)[:, :, 0]
    bpy.data.images.remove(image)
    return values, after.user + after.system - before.user - before.system


# What a render costs whatever its samples is not counted.
render(0, 1)
overhead = min(render(0, 1)[1] for _ in range(2))
runs = [render(seed + 1, samples) for seed in range(seeds)]
pictures = numpy.stack([values for values, _ in runs])

# Blender's rows begin at the bottom.
mask = numpy.array([[c == "1" for c in row] for row in open(mask_file).read().split()])[::-1]
means = pictures[:, mask].mean(axis=1)
variance = pictures.var(axis=0, ddof=1)[mask].mean()
cpu = sum(c for _, c in runs) / seeds - overhead * (samples - 1) / samples
print(f"{name} cycles mean {means.mean():.6f} +- {means.std(ddof=1) / math.sqrt(seeds):.6f} "
      f"variance {variance:.4e} cpu {cpu:.3f} efficiency {1 / (variance * cpu):.5g}")
