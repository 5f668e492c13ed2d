"""Run by Blender: imports FILE.glb and FILE.bvh, and prints what is there in frames 1 and 30."""
import json
import sys

import bpy
import io_anim_bvh.import_bvh

# Blender 3.4 of Debian 12 opens BVH files in a mode that its Python does not have any more.
io_anim_bvh.import_bvh.open = lambda file, mode: open(file, mode.replace('U', ''), encoding='utf-8')
glb, bvh = sys.argv[sys.argv.index('--') + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.context.scene.render.fps = 30
bpy.ops.import_scene.gltf(filepath=glb, import_shading='SMOOTH')
people = [thing for thing in bpy.data.objects if thing.type == 'ARMATURE']
found = {'people': len(people), 'meshes': sum(thing.type == 'MESH' for thing in bpy.data.objects)}
for frame in (1, 30):
    bpy.context.scene.frame_set(frame)
    found[frame] = {person.name: list(person.location[:2]) for person in people}
bpy.ops.import_anim.bvh(filepath=bvh)
found['bvh'] = len(bpy.context.object.data.bones), list(bpy.context.object.pose.bones['hips'].head)
print('FOUND ' + json.dumps(found))
