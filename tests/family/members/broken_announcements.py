"""What the next gesture will mean was announced, and then all was called off: the gesture is none that anybody explained."""
import things

# Both leave the dialogue: from where nothing is open, and from a question about something else.
ASIDE = {"place_setting": "put the knife", "workbench": "put the red block", "staircase": "put the red block",
         "emre_table": "put the knife"}
SIGNS = ["twirl", "swirl", "flutter", "wiggle"]
VERBS = ["lift", "take"]


def members():
    for k, (scene, thing, name) in enumerate(things.everything()):
        sign, verb = SIGNS[k % 4], VERBS[k % 2]
        told = f"this means {verb} {name}"
        shown = [{"gesture": sign}]
        yield {"id": f"broken_announcements {scene} {thing} called off", "scene": scene,
               "say": [told, "never mind", shown], "expect": {"no_act": True, "asks": True}}
        yield {"id": f"broken_announcements {scene} {thing} kept", "scene": scene, "say": [told, shown, shown],
               "expect": {"acts": [f"{verb} {thing}"]}}
        if k % 2:
            yield {"id": f"broken_announcements {scene} {thing} called off in a question", "scene": scene,
                   "say": [told, ASIDE[scene], "never mind", shown], "expect": {"no_act": True, "asks": True}}
