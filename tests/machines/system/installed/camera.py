"""A camera on the USB, plugged into a running kiosk: what lies under it is taken and felt; lost, and found again."""
from machine import Fault, Redirected


def run(table, bench):
    kiosk = bench.ready(table, 'camera')
    program = f'{bench.devices}/redirected_camera'
    with table.check('camera', 'none: the kiosk says so'):
        _wait_lost(kiosk)
    with table.check('camera', 'plugged in: a picture is taken and can be felt'):
        camera = Redirected(kiosk.machine, program)
        _take(kiosk)
    with table.check('camera', 'pulled out: the kiosk says so and stays') as note:
        process = kiosk.process()
        note(camera.pull())
        _wait_lost(kiosk)
    with table.check('camera', 'plugged in again: another picture'):
        camera = Redirected(kiosk.machine, program)
        _take(kiosk)
        camera.pull()
        if kiosk.process() != process:
            raise Fault('the kiosk was started again')


def _take(kiosk):
    kiosk.to_choose()
    kiosk.to_item('Camera')
    kiosk.press('ret')
    kiosk.machine.wait_screen(['under the camera'])
    kiosk.to_item('Take the photo')
    kiosk.press('ret')
    if not kiosk.is_felt():
        raise Fault(f'no picture: {kiosk.machine.screen()}')


def _wait_lost(kiosk):
    kiosk.to_choose()
    kiosk.to_item('Camera')
    kiosk.machine.wait_screen(['Camera', 'not ready'])
