"""Check of the certificate of an exported asset: it exists, proves all pairs, and its proof is valid."""

from functools import partial

from artgen.asset import Asset
from artgen.asset.certificate import Certificate, PairResult, spelled_region
from artgen.asset.collision import mesh_precision
from artgen.asset.report import CheckResult, Finding

_CHECK = "certificate"
_CERTIFY = (
    "generate with certification or asset.certify() before export; colliders of other kinds than 'exact' are "
    "proven by artgen.Asset.load(directory).certify()"
)
_MEND = "shorten the limits to asset.safe_limits(), or move the pivot"
_MEND_AT_REST = (
    "they overlap at rest: move one of the parts, or allow the contact with body.allow_contact(...)"
)
_MEND_OPEN = "give the two pieces more clearance there, or shorten the limits to asset.safe_limits()"

_fault = partial(Finding, _CHECK)


def check_certificate(asset: Asset, *, meshes: bool = True) -> CheckResult:
    """Check that an asset has a certificate for all pairs and that its proof is valid.

    `artgen.proof.recheck` verifies the stored proof independently of the search.
    """
    certificate = asset.certificate
    if certificate is None:
        message = "there is no certificate: nothing is proven about collisions between its links"
        return CheckResult(_CHECK, (_fault(message, hint=_CERTIFY),))
    findings = [_pair_finding(asset, pair) for pair in certificate.failures]
    for contact in certificate.contacts:
        if contact not in asset.contacts:
            message = f"the certificate allows a contact that the asset does not declare: {contact}"
            link, hint = ", ".join(contact.links), "certify the asset again"
            findings.append(_fault(message, link, value=contact.depth, unit="m", hint=hint))
    if mesh_precision(*asset.links):
        message = "an export with a mesh precision does not keep it"
        hint = "export with mesh_precision=0 as well"
    elif not meshes:
        message = "the export has no meshes to compare its pieces with"
        hint = "export with urdf or mjcf as well"
    else:
        from artgen.proof.recheck import recheck

        return CheckResult(_CHECK, (*findings, *recheck(asset, certificate)), _detail(certificate))
    findings.append(_fault(f"the proof is not verified: {message}", hint=hint, severity="note"))
    return CheckResult(_CHECK, tuple(findings), _detail(certificate))


def _detail(certificate: Certificate) -> str:
    count = len(certificate.pairs)
    pairs = f"{count} pair{'' if count == 1 else 's'} of links"
    parts = [f"{pairs}, tolerance {1e3 * certificate.tolerance:.4g} mm" if count else "nothing moves"]
    closest = certificate.clearance
    if closest is not None and closest.guaranteed is not None:
        parts.append(f"{' and '.join(closest.links)} never closer than {1e3 * closest.guaranteed:.4g} mm")
    if certificate.contacts:
        parts.append("allowed contacts: " + "; ".join(map(str, certificate.contacts)))
    return ", ".join(parts)


def _pair_finding(asset: Asset, pair: PairResult) -> Finding:
    """Return the collision of a pair, or the region in which it is not proven."""
    link, witness = ", ".join(pair.links), pair.witness
    if witness is None:
        which = "not proven" if pair.verdict != "proven" else "not proven for their colliders"
        message = f"{which} in {100 * pair.open_fraction:.3g} % of their joint space"
        pose: dict[str, float] = {}
        if pair.open_cells:
            cell = pair.open_cells[0]
            first, second = cell.labels
            where = f"where {first} is {1e3 * cell.distance:.3f} mm from {second}"
            message += f", such as {spelled_region(cell.region)}, {where}"
            pose = {name: (low + high) / 2 for name, (low, high) in cell.region.items()}
        return _fault(message, link, value=pair.open_fraction, pose=pose, hint=_MEND_OPEN)
    first, second = witness.labels
    x, y, z = witness.place
    contact = ", ".join(f"{name}={position:.4g}" for name, position in witness.first_contact.items())
    at_rest = all(
        abs(position - asset.joint(name).closed) < 1e-9 for name, position in witness.first_contact.items()
    )
    both = pair.verdict == "collision"
    message = (
        f"{'they collide' if both else 'only their colliders collide, not their solids'}: "
        f"{first} presses {1e3 * witness.depth:.3f} mm into {second} "
        f"at ({x:.3f}, {y:.3f}, {z:.3f}) m; first contact at {'rest' if at_rest else contact}"
    )
    hint = _MEND_AT_REST if at_rest else _MEND
    return _fault(message, link, value=witness.depth, unit="m", pose=witness.pose, hint=hint)
